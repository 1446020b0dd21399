// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "backend/cpu/threads.h"
#include "surface/kernel_shape.h"
#include "surface/particle_bins.h"

namespace freshet {

inline constexpr float longest_stretch = 1.4f;  ///< of a kernel's axis
inline constexpr float shape_reach = 2;  ///< radius of a particle's surroundings, of the kernel's

/// The kernels of particles whose shapes follow the liquid [after Yu and Turk 2013]. Values are in
/// the order of the frame.
struct Anisotropy {
  std::vector<KernelShape> shape;
  std::vector<Vec<3, float>> shift;  ///< of the centres [cells]
};

/// A kernel is stretched along the liquid's surface by the covariance of the particles around it.
/// Across the surface it stays as it is, so that the level stays where it is. Particles with few
/// neighbours keep round kernels.
///
/// Centres move towards the mean of the particles around them. All particles at a surface would
/// move inwards by this; what their neighbours in the same layer move by is subtracted. So bumps
/// are flattened, and the layers keep their distance.
///
/// `bins` has a support of `shape_reach` · `support` [cells].
Anisotropy anisotropy_of(const ParticleBins& bins, float support, float spacing,
                         const Threads& threads);

}  // namespace freshet

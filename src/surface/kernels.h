// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "backend/cpu/threads.h"
#include "surface/kernel_shape.h"
#include "surface/particle_bins.h"

namespace freshet {

/// How much less volume the particles of films and threads get. A film of one particle lacks the
/// layers behind a pool's surface, so its density falls off more slowly than a pool's: the same
/// level would make it thicker. Its particles have fewer neighbours than deep ones, but on opposite
/// sides, while those at a pool's surface or edge have them on one side.
struct FilmModel {
  float deep = 2;      ///< sum of splines deep in the liquid
  float flat = 1;      ///< Σ w·(x_j - x_i) at a flat surface [cells]
  float strength = 0;  ///< 0: none

  FilmModel() = default;
  /// For particles on a lattice of this spacing [cells]: a film is as thick as its layer.
  FilmModel(float support, float spacing);
  /// The factor of the volume of a particle with these sums over its neighbours, itself included.
  float factor(float sum, float moment) const;
};

/// The kernels of the particles, in the order of ParticleBins.
struct Kernels {
  float radius;               ///< of a round kernel [cells]; the bins' support is as long or longer
  std::vector<float> volume;  ///< the weight of each
  std::vector<KernelShape> shape;  ///< empty: all are round

  /// The longest axis of a particle's kernel [cells].
  float reach(int particle) const {
    return shape.empty() ? radius : radius * shape[std::size_t(particle)].reach;
  }
  bool is_round(int particle) const {
    return shape.empty() || shape[std::size_t(particle)].reach == 1;
  }
};

/// Kernels whose volumes are the inverse of each particle's sum of splines over its neighbours,
/// itself included, in units that make a lone particle's 1 [Solenthaler and Pajarola 2008, number
/// density]. Weighted by it, particles fill their surroundings evenly whether they are dense or
/// sparse. Particles of films get less: `films` has how much.
Kernels kernels_of(const ParticleBins& bins, float radius, std::vector<KernelShape> shapes,
                   const FilmModel& films, const Threads& threads);

}  // namespace freshet

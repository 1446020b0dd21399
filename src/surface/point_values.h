// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "surface/marching_cubes.h"

namespace freshet {

/// Values of the points of a mesh, computed from the particles around each.
struct PointValues {
  /// The mean of the particles' velocities, weighted by volume and spline. Empty if the frame has
  /// none.
  std::vector<std::array<float, 3>> velocity;
  /// 0 at the surface of a lone particle, 1 at a flat surface of a liquid: how much of the
  /// surroundings the particles fill.
  std::vector<float> fill;
  /// The direction out of the liquid, against the field's gradient; a unit vector, or zero where
  /// the field has no gradient.
  std::vector<Vec<3, float>> normal;
  /// The step to where the field has its level [cells]: Newton's, as marching cubes interpolate
  /// linearly.
  std::vector<Vec<3, float>> step;
};

/// The field that a mesh is the surface of.
struct SurfaceField {
  const ParticleBins& bins;
  const Kernels& kernels;
  const std::vector<float>& velocity;  ///< three numbers per particle of the frame, or empty
  float level;                         ///< of the mesh
  float deep;                          ///< sum of splines deep in the liquid
};

/// The values of all points of a mesh of marching_cubes().
PointValues point_values(const GridMesh& mesh, const DensityField& blocks,
                         const SurfaceField& field, const Threads& threads);

}  // namespace freshet

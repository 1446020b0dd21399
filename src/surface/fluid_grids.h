// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/surface.h"
#include "surface/level_set.h"

namespace freshet {

/// A fluid as values at the points of a grid.
struct FluidGrids {
  using Values = LevelSet::Values;
  std::array<double, 3> origin{};  ///< of the points [m]
  double cell = 1;                 ///< [m]
  LevelSet distance;               ///< from the surface
  std::vector<Place> blocks;       ///< near particles, ascending by key_of()
  /// Of blocks: 0 far from particles, about 1 deep in the fluid.
  std::vector<Values> density;
  /// Of blocks: the mean of the particles' velocities, weighted by volume and spline, 0 where the
  /// density is 0 [m/s]. Empty if the frame has none.
  std::vector<std::array<Values, 3>> velocity;
};

/// The grids of the particles of a frame. Arguments, errors and the surface are those of
/// surface_of().
FluidGrids grids_of(const Frame& frame, double spacing, const std::array<double, 3>& origin,
                    const SurfaceSettings& settings = {}, int threads = 0);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "surface/marching_cubes.h"

namespace freshet {

/// Signed distances from a mesh at the points of the grid, in blocks near the surface only [cells].
struct LevelSet {
  static constexpr float band = 3;  ///< distances are known up to this one
  using Values = std::array<float, block_points>;
  /// Blocks with a point within the band, ascending by key_of(), and their values: negative inside,
  /// ±band at points beyond the band.
  std::vector<Place> blocks;
  std::vector<Values> values;
  std::vector<Place> inside;  ///< blocks all of whose points are deeper than the band
};

/// The level set of a closed mesh. A point is inside where the winding number of the mesh is
/// positive.
LevelSet level_set_of(const GridMesh& mesh, const Threads& threads);

}  // namespace freshet

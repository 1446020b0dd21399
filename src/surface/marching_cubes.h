// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "surface/density_field.h"

namespace freshet {

/// An indexed mesh in grid cells.
struct GridMesh {
  using Point = Vec<3, double>;
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Point> points;
  std::vector<Triangle> triangles;       ///< counterclockwise seen from outside the fluid
  std::vector<std::uint32_t> block_end;  ///< points of block b end here, in the field's order
};

/// The surface where the field has a level > 0 [marching cubes with the cases of cube_table()]. It
/// is closed and manifold. Throws Error (kind run) if it has more than 2^32 points or triangles.
GridMesh marching_cubes(const DensityField& field, float level, const Threads& threads);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "surface/marching_cubes.h"

namespace freshet {

/// Removes triangles where the mesh is flat, by collapsing edges with errors up to `error` [cells;
/// the quadric metric of Garland and Heckbert 1997]. The mesh stays closed and manifold. Returns
/// the former number of each point that stays. Needs simplifies_surfaces().
std::vector<std::uint32_t> simplify(GridMesh& mesh, double error, const Threads& threads);

}  // namespace freshet

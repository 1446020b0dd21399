// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "surface/marching_cubes.h"

namespace freshet {

/// The triangles at edges and points where a mesh is not a closed manifold: edges that are not in
/// two triangles of opposite directions, pairs of triangles with the same corners, and points with
/// more than one fan of triangles around them.
std::vector<std::uint32_t> defective_triangles(const std::vector<GridMesh::Triangle>& triangles);

}  // namespace freshet

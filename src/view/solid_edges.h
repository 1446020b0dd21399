// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace freshet::view {

/// The edges at which the normals of both faces differ by more than 30 degrees, or that have one
/// face.
std::vector<std::pair<TriangleMesh::Point, TriangleMesh::Point>> sharp_edges(
    const TriangleMesh& mesh);

/// The normals at the corners of each triangle: the mean of the faces around a point that turn by
/// less than 30 degrees.
std::vector<std::array<TriangleMesh::Point, 3>> smooth_normals(const TriangleMesh& mesh);

}  // namespace freshet::view

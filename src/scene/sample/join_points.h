// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/triangle_mesh.h"

namespace freshet {

/// Joins each two points (2D) or three points (3D) that are near each other: by strips along z in
/// 2D, by triangles in 3D. Nearness depends on the median distance of neighbours, and on the
/// spacing of the fluid: wider gaps are openings.
TriangleMesh join_points(const std::vector<double>& x, int dimension, double spacing);

}  // namespace freshet

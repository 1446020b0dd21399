// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "mesh/mesh_distance.h"
#include "scene/model/setup.h"

namespace freshet {

/// The triangles of the walls without an inside: meshes with holes, and walls of points, whose near
/// points are joined by triangles, in 2D by strips along z. Walls are repeated beyond periodic
/// ends. Empty if there are none. The scene must have its defaults filled in.
std::optional<MeshDistance> membranes_of(const Scene& scene);

/// Joins each two points (2D) or three points (3D) that are near each other. Nearness depends on
/// the median distance of neighbours, and on the spacing of the fluid: wider gaps are openings.
TriangleMesh join_points(const std::vector<double>& x, int dimension, double spacing);

}  // namespace freshet

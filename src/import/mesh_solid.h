// SPDX-License-Identifier: MIT
/// Simple solids among meshes, and the section of a mesh.
#pragma once
#include <optional>
#include <vector>

#include "import/placement.h"
#include "mesh/triangle_mesh.h"

namespace freshet {

/// The solid that a mesh draws, before it is rotated and translated.
struct MeshSolid {
  enum class Kind { box, sphere, cylinder, other };
  Kind kind = Kind::other;
  Bounds bounds;
  double radius = 0;  ///< of a sphere, or of a cylinder along y
};

/// Recognises boxes along the axes, spheres, and cylinders along y among meshes that are scaled.
/// A sphere or a cylinder of triangles counts if its corners are on one within 1 % of the radius.
MeshSolid solid_of_mesh(const TriangleMesh& mesh, const Vec<3, double>& scale);

/// The corners of the loops where the placed mesh cuts z = 0. Corners closer than `apart` to the
/// one before are skipped, and loops of less than three corners.
std::vector<std::vector<Vec<3, double>>> section_of_mesh(const TriangleMesh& mesh,
                                                         const Placement& place, double apart);

}  // namespace freshet

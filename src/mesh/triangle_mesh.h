// SPDX-License-Identifier: MIT
/// Surfaces made of triangles: read, mended, and asked whether they enclose something.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/vec.h"

namespace freshet {

struct TriangleMesh {
  using Point = Vec<3, double>;
  using Triangle = std::array<int, 3>;  ///< counterclockwise as seen from outside
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  std::array<Point, 3> corners(int triangle) const {
    const auto [a, b, c] = triangles[std::size_t(triangle)];
    return {points[std::size_t(a)], points[std::size_t(b)], points[std::size_t(c)]};
  }
};

/// Whether this build reads files of triangles: it does where it found Assimp.
bool reads_meshes();

/// Reads the triangles of a *.stl, *.obj or *.ply file; faces of more corners are cut into
/// triangles, lines and lone points are left out. Throws Error (kind scene) at FILE.
TriangleMesh read_mesh(const std::filesystem::path& file);

/// What mend_mesh found, and did.
struct MeshCondition {
  std::int64_t merged = 0;        ///< points that lay on another
  std::int64_t degenerate = 0;    ///< triangles removed: two of their corners are one point
  std::int64_t doubled = 0;       ///< triangles removed: another has the same corners
  std::int64_t turned = 0;        ///< triangles turned over: they faced the other way than the rest
  std::int64_t open = 0;          ///< edges that only one triangle has
  std::int64_t crowded = 0;       ///< edges that more than two triangles have
  TriangleMesh::Point open_at{};  ///< the middle of the first open edge
  bool closed() const { return open == 0; }
};

/// Makes one point of those that lie together (nearer than 1e-7 of the mesh's diagonal), removes
/// triangles that are none, turns those that face the other way than their neighbours, and then
/// whole shells that are inside out. A shell inside another that faces inwards stays: it is a
/// hollow.
MeshCondition mend_mesh(TriangleMesh& mesh);

}  // namespace freshet

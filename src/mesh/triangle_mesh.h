// SPDX-License-Identifier: MIT
/// Triangle meshes: reading, repair, and a test whether they are closed.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/vec.h"

namespace freshet {

struct TriangleMesh {
  using Point = Vec<3, double>;
  using Triangle = std::array<int, 3>;  ///< counterclockwise seen from outside
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  std::array<Point, 3> corners(int triangle) const {
    const auto [a, b, c] = triangles[std::size_t(triangle)];
    return {points[std::size_t(a)], points[std::size_t(b)], points[std::size_t(c)]};
  }
};

/// A box of twelve triangles that face outwards.
inline TriangleMesh triangles_of_box(TriangleMesh::Point low, TriangleMesh::Point high) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Whether this build reads *.stl and *.obj files, which needs Assimp. Every build reads *.ply.
bool reads_meshes();

/// Reads the triangles of a *.stl, *.obj or *.ply file. Polygons are split into triangles; lines
/// and single points are skipped. Throws Error (kind scene) at FILE.
TriangleMesh read_mesh(const std::filesystem::path& file);
/// Reads a mesh from the bytes of a file. The extension of `file` selects the format.
TriangleMesh mesh_in(std::string_view bytes, const std::filesystem::path& file);

/// A hole is a loop of edges that have one triangle only.
struct MeshHole {
  TriangleMesh::Point middle{};  ///< mean of its corners [m]
  double perimeter = 0;          ///< [m]
  double width = 0;              ///< hydraulic diameter, 4 area/perimeter: small for a crack [m]
  std::int64_t edges = 0;
  bool filled = false;
};

/// The findings and repairs of mend_mesh.
struct MeshCondition {
  std::int64_t merged = 0;      ///< points that coincided with another
  std::int64_t degenerate = 0;  ///< triangles removed: two of their corners are one point
  std::int64_t doubled = 0;     ///< triangles removed: another has the same corners
  std::int64_t turned = 0;      ///< triangles turned: they faced opposite to the rest
  std::int64_t open = 0;        ///< edges of only one triangle, after holes were filled
  std::int64_t crowded = 0;     ///< edges of more than two triangles
  std::vector<MeshHole> holes;  ///< the widest first
  bool closed() const { return open == 0; }
  /// The widest hole that was not filled; the mesh must have one.
  const MeshHole& widest_open() const;
};

/// Repairs a mesh. It merges points closer than 1e-7 of the mesh's diagonal and removes degenerate
/// and duplicate triangles. It turns triangles that face opposite to their neighbours, then whole
/// shells that are inside out. A shell inside another that faces inwards stays: it is a hollow.
/// Holes narrower than `fill_below` [m] are filled.
MeshCondition mend_mesh(TriangleMesh& mesh, double fill_below = 0);

}  // namespace freshet

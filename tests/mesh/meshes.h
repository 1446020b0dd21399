// SPDX-License-Identifier: MIT
/// Small meshes for tests.
#pragma once
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "mesh/triangle_mesh.h"

namespace freshet::test {

using Point = TriangleMesh::Point;

/// A box of twelve triangles that face outwards.
inline TriangleMesh box_mesh(Point low, Point high) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A sphere about the origin: an octahedron whose faces are divided into four `cuts` times.
inline TriangleMesh ball_mesh(double radius, int cuts) {
  TriangleMesh mesh{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int cut = 0; cut < cuts; ++cut) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, fresh] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, int(mesh.points.size()));
      if (fresh) {
        const Point m = mesh.points[std::size_t(a)] + mesh.points[std::size_t(b)];
        mesh.points.push_back(m / norm(m));
      }
      return it->second;
    };
    std::vector<TriangleMesh::Triangle> cut_up;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const TriangleMesh::Triangle& t :
           {TriangleMesh::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        cut_up.push_back(t);
    }
    mesh.triangles = cut_up;
  }
  for (Point& p : mesh.points) p = radius * p;
  return mesh;
}

inline std::string stl_of(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "solid made by hand\n";
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const Point& p : mesh.corners(int(k)))
      text << "vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid made by hand\n";
  return text.str();
}

}  // namespace freshet::test

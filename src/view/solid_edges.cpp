// SPDX-License-Identifier: MIT
#include "view/solid_edges.h"

#include <map>

#include "view/shapes.h"

namespace freshet::view {
namespace {

constexpr double smooth_cosine = 0.866;  // of 30 degrees

using Place = TriangleMesh::Point;

/// Twice the area along the normal.
Place area_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto c = mesh.corners(int(triangle));
  return cross(c[1] - c[0], c[2] - c[0]);
}

bool smooth(Place a, Place b) { return dot(a, b) > smooth_cosine * norm(a) * norm(b); }

}  // namespace

std::vector<std::pair<Place, Place>> sharp_edges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> faces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      faces[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
  std::vector<std::pair<Place, Place>> edges;
  for (const auto& [ends, around] : faces)
    if (around.size() != 2 || !smooth(area_of(mesh, around[0]), area_of(mesh, around[1])))
      edges.emplace_back(mesh.points[std::size_t(ends.first)],
                         mesh.points[std::size_t(ends.second)]);
  return edges;
}

std::vector<std::array<Place, 3>> smooth_normals(const TriangleMesh& mesh) {
  std::vector<std::vector<std::size_t>> faces(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int p : mesh.triangles[t]) faces[std::size_t(p)].push_back(t);
  std::vector<std::array<Place, 3>> normals(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place own = area_of(mesh, t);
      Place sum{0, 0, 0};
      for (const std::size_t other : faces[std::size_t(mesh.triangles[t][k])])
        if (const Place area = area_of(mesh, other); smooth(own, area)) sum += area;
      const double length = norm(sum);
      normals[t][k] = length > 0 ? sum / length : Place{0, 1, 0};
    }
  return normals;
}

std::vector<TriangleMesh::Triangle> triangulate(const std::vector<Vec<2, double>>& corners) {
  std::vector<int> left;
  for (std::size_t k = 0; k < corners.size(); ++k) left.push_back(int(k));
  const auto turn = [&](int a, int b, int c) {
    const auto &p = corners[std::size_t(a)], &q = corners[std::size_t(b)],
               &r = corners[std::size_t(c)];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  std::vector<TriangleMesh::Triangle> triangles;
  std::size_t tried = 0;
  for (std::size_t k = 0; left.size() > 3 && tried <= left.size(); ++tried) {
    const std::size_t n = left.size();
    const int a = left[(k + n - 1) % n], b = left[k % n], c = left[(k + 1) % n];
    bool ear = turn(a, b, c) > 0;
    for (const int p : left)
      ear = ear && (p == a || p == b || p == c || turn(a, b, p) < 0 || turn(b, c, p) < 0 ||
                    turn(c, a, p) < 0);
    if (!ear) {
      k = (k + 1) % n;
      continue;
    }
    triangles.push_back({a, b, c});
    left.erase(left.begin() + std::ptrdiff_t(k % n));
    k %= left.size();
    tried = 0;
  }
  if (left.size() == 3) triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace freshet::view

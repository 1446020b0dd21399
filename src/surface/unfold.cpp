// SPDX-License-Identifier: MIT
#include "surface/unfold.h"

#include <algorithm>
#include <unordered_map>

namespace freshet {
namespace {

using Triangle = GridMesh::Triangle;

/// Edges in the direction of their triangle, with its number.
class TriangleOfEdge {
 public:
  explicit TriangleOfEdge(const std::vector<Triangle>& triangles) {
    all_.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) add(triangles[t], t);
  }
  void add(const Triangle& t, std::uint32_t number) {
    for (std::size_t c = 0; c < 3; ++c) all_[key(t[c], t[(c + 1) % 3])] = number;
  }
  void remove(std::uint32_t from, std::uint32_t to) { all_.erase(key(from, to)); }
  bool contains(std::uint32_t from, std::uint32_t to) const { return all_.contains(key(from, to)); }
  std::uint32_t at(std::uint32_t from, std::uint32_t to) const { return all_.at(key(from, to)); }

 private:
  static std::uint64_t key(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t(from) << 32 | to;
  }
  std::unordered_map<std::uint64_t, std::uint32_t> all_;
};

/// The mesh and its edges.
class Unfold {
 public:
  Unfold(GridMesh& mesh, const std::vector<GridMesh::Point>& normals)
      : mesh_(mesh), normals_(normals), edges_(mesh.triangles) {}
  void run() {
    constexpr int passes = 4;
    for (int pass = 0; pass < passes; ++pass)
      for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
        if (facing(mesh_.triangles[t]) < folded) swap_longest_edge(t);
  }

 private:
  static constexpr double folded = 0.3;
  /// The cosine between a triangle and the surface before, at the corner where it is smallest.
  double facing(const Triangle& t) const {
    const GridMesh::Point a = mesh_.points[t[0]];
    const GridMesh::Point area = cross(mesh_.points[t[1]] - a, mesh_.points[t[2]] - a);
    double least = 1;
    for (const std::uint32_t c : t)
      least = std::min(least, dot(area, normals_[c]) / (norm(area) * norm(normals_[c]) + 1e-30));
    return least;
  }
  /// Replaces the longest edge of a triangle by the other diagonal of the quadrilateral around it,
  /// if that is better.
  void swap_longest_edge(std::uint32_t t) {
    const Triangle own = mesh_.triangles[t];
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t c = 0; c < 3; ++c)
      if (const double l = norm2(mesh_.points[own[(c + 1) % 3]] - mesh_.points[own[c]]);
          l > length) {
        length = l;
        longest = c;
      }
    const std::uint32_t a = own[longest], b = own[(longest + 1) % 3], c = own[(longest + 2) % 3];
    const std::uint32_t u = edges_.at(b, a);
    const Triangle other = mesh_.triangles[u];
    std::uint32_t d = other[0];
    for (const std::uint32_t k : other)
      if (k != a && k != b) d = k;
    if (c == d || edges_.contains(c, d) || edges_.contains(d, c)) return;
    const Triangle first{a, d, c}, second{d, b, c};
    if (std::min(facing(first), facing(second)) <= std::min(facing(own), facing(other))) return;
    edges_.remove(a, b);
    edges_.remove(b, a);
    mesh_.triangles[t] = first;
    mesh_.triangles[u] = second;
    edges_.add(first, t);
    edges_.add(second, u);
  }

  GridMesh& mesh_;
  const std::vector<GridMesh::Point>& normals_;
  TriangleOfEdge edges_;
};

}  // namespace

void unfold(GridMesh& mesh, const std::vector<GridMesh::Point>& normals) {
  Unfold(mesh, normals).run();
}

}  // namespace freshet

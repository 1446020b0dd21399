// SPDX-License-Identifier: MIT
#include "surface/mesh_defects.h"

#include <algorithm>

namespace freshet {
namespace {

/// An edge in the direction of its triangle.
struct Edge {
  std::uint32_t from, to, third, triangle;
  friend bool operator<(const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  }
  bool joins(std::uint32_t a, std::uint32_t b) const { return from == a && to == b; }
};

/// The edges of a mesh, by their first corner, then their second.
class Edges {
 public:
  explicit Edges(const std::vector<GridMesh::Triangle>& triangles) {
    all_.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c)
        all_.push_back({triangles[t][c], triangles[t][(c + 1) % 3], triangles[t][(c + 2) % 3], t});
    std::sort(all_.begin(), all_.end());
  }
  const std::vector<Edge>& all() const { return all_; }
  /// The only edge between two points in this direction; null if it is missing or there are more.
  const Edge* find(std::uint32_t from, std::uint32_t to) const {
    const auto at = std::lower_bound(all_.begin(), all_.end(), Edge{from, to, 0, 0});
    if (at == all_.end() || !at->joins(from, to)) return nullptr;
    const auto next = at + 1;
    return next != all_.end() && next->joins(from, to) ? nullptr : &*at;
  }
  bool is_good(const Edge& e) const {
    const Edge* back = find(e.to, e.from);
    return find(e.from, e.to) && back && back->third != e.third;
  }

 private:
  std::vector<Edge> all_;
};

}  // namespace

std::vector<std::uint32_t> defective_triangles(const std::vector<GridMesh::Triangle>& triangles) {
  const Edges edges(triangles);
  std::vector<std::uint32_t> wrong;
  for (const Edge& e : edges.all())
    if (!edges.is_good(e)) wrong.push_back(e.triangle);
  if (!wrong.empty()) return wrong;
  // all edges are good: walk around each point, from triangle to triangle
  for (auto first = edges.all().begin(); first != edges.all().end();) {
    auto end = first;
    while (end != edges.all().end() && end->from == first->from) ++end;
    std::size_t around = 0;
    const Edge* at = &*first;
    do {
      at = edges.find(first->from, at->third);
      ++around;
    } while (at->to != first->to);
    if (around != std::size_t(end - first))
      for (auto e = first; e != end; ++e) wrong.push_back(e->triangle);
    first = end;
  }
  return wrong;
}

}  // namespace freshet

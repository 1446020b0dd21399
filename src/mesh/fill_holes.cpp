// SPDX-License-Identifier: MIT
#include "mesh/fill_holes.h"

#include <algorithm>
#include <limits>
#include <map>

namespace freshet {
namespace {

using Point = TriangleMesh::Point;
using Triangle = TriangleMesh::Triangle;
using Loop = std::vector<int>;  // the points around a hole

constexpr std::size_t most_edges = 300;  // of a filled hole: the work grows with their cube
constexpr double most_area = 0.1;        // of the mesh, of all filled holes together

struct Boundary {
  std::vector<Loop> loops, ends;  // closed paths, and paths that end
};

/// The boundary of a mesh, each edge passed against its triangle. A path that meets itself is cut
/// there.
Boundary boundary_of(const OpenEdges& open) {
  std::map<int, std::vector<int>> next;
  for (const auto& [a, b] : open) next[b].push_back(a);
  Boundary all;
  for (auto& start : next)
    while (!start.second.empty()) {
      Loop path{start.first};
      std::map<int, std::size_t> place{{start.first, 0}};
      for (auto out = next.find(path.back()); out != next.end() && !out->second.empty();
           out = next.find(path.back())) {
        const int to = out->second.back();
        out->second.pop_back();
        const auto [met, fresh] = place.try_emplace(to, path.size());
        if (fresh) {
          path.push_back(to);
          continue;
        }
        const auto first = path.begin() + std::ptrdiff_t(met->second);
        all.loops.emplace_back(first, path.end());
        for (auto it = first + 1; it != path.end(); ++it) place.erase(*it);
        path.erase(first + 1, path.end());
      }
      if (path.size() > 1) all.ends.push_back(path);
    }
  return all;
}

/// The triangulation of minimal area of the polygon through the points of a loop.
class Patch {
 public:
  Patch(const TriangleMesh& mesh, const Loop& loop)
      : mesh_(mesh), loop_(loop), n_(loop.size()), area_(n_ * n_), middle_(n_ * n_) {
    for (std::size_t span = 2; span < n_; ++span)
      for (std::size_t i = 0; i + span < n_; ++i) divide(i, i + span);
  }
  double area() const { return area_[n_ - 1]; }
  void add_to(std::vector<Triangle>& all) const { add(0, n_ - 1, all); }

 private:
  double area_of(std::size_t i, std::size_t j, std::size_t k) const {
    const auto at = [&](std::size_t p) { return mesh_.points[std::size_t(loop_[p])]; };
    return 0.5 * norm(cross(at(j) - at(i), at(k) - at(i)));
  }
  /// The best triangle on the side from i to j of the polygon i, i + 1, ..., j.
  void divide(std::size_t i, std::size_t j) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t m = i + 1; m < j; ++m) {
      const double area = area_[i * n_ + m] + area_[m * n_ + j] + area_of(i, m, j);
      if (!(area < least)) continue;
      least = area;
      middle_[i * n_ + j] = m;
    }
    area_[i * n_ + j] = least;
  }
  void add(std::size_t i, std::size_t j, std::vector<Triangle>& all) const {
    if (j < i + 2) return;
    const std::size_t m = middle_[i * n_ + j];
    all.push_back({loop_[i], loop_[m], loop_[j]});
    add(i, m, all);
    add(m, j, all);
  }

  const TriangleMesh& mesh_;
  const Loop& loop_;
  std::size_t n_;
  std::vector<double> area_;  // of the polygon from i to j, at i n + j
  std::vector<std::size_t> middle_;
};

double area_of(const TriangleMesh& mesh) {
  double area = 0;
  for (int t = 0; t < int(mesh.triangles.size()); ++t) {
    const auto c = mesh.corners(t);
    area += 0.5 * norm(cross(c[1] - c[0], c[2] - c[0]));
  }
  return area;
}

/// A hole whose area is that of the triangles between its edges and its middle.
MeshHole hole_of(const TriangleMesh& mesh, const Loop& loop) {
  const auto at = [&](std::size_t k) { return mesh.points[std::size_t(loop[k % loop.size()])]; };
  MeshHole hole;
  hole.edges = std::int64_t(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) hole.middle += at(k) / double(loop.size());
  double area = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    area += 0.5 * norm(cross(at(k) - hole.middle, at(k + 1) - hole.middle));
    hole.perimeter += norm(at(k + 1) - at(k));
  }
  hole.width = 4 * area / hole.perimeter;
  return hole;
}

}  // namespace

const MeshHole& MeshCondition::widest_open() const {
  return *std::find_if(holes.begin(), holes.end(), [](const MeshHole& h) { return !h.filled; });
}

void fill_holes(TriangleMesh& mesh, const OpenEdges& open, double width, MeshCondition& found) {
  const Boundary boundary = boundary_of(open);
  std::vector<Triangle> patches;
  double area = 0;
  for (const Loop& loop : boundary.loops) {
    found.holes.push_back(hole_of(mesh, loop));
    if (!(width > 0) || loop.size() < 3 || loop.size() > most_edges) continue;
    MeshHole& hole = found.holes.back();
    const Patch patch(mesh, loop);
    hole.width = 4 * patch.area() / hole.perimeter;
    hole.filled = hole.width < width;
    if (!hole.filled) continue;
    patch.add_to(patches);
    area += patch.area();
  }
  for (const Loop& end : boundary.ends) found.holes.push_back(hole_of(mesh, end));
  std::stable_sort(found.holes.begin(), found.holes.end(),
                   [](const MeshHole& a, const MeshHole& b) { return a.width > b.width; });
  if (area <= most_area * area_of(mesh))
    mesh.triangles.insert(mesh.triangles.end(), patches.begin(), patches.end());
  else
    for (MeshHole& hole : found.holes) hole.filled = false;
}

}  // namespace freshet

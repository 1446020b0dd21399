// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "mesh/mesh_distance.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;
using Triangle = TriangleMesh::Triangle;

double diagonal_of(const TriangleMesh& mesh) {
  Point low = mesh.points[0], high = low;
  for (const Point& x : mesh.points) {
    low = each(low, x, [](double a, double b) { return std::min(a, b); });
    high = each(high, x, [](double a, double b) { return std::max(a, b); });
  }
  return norm(high - low);
}

/// For each point the lowest index of the points that coincide with it, closer than `apart` [m].
std::vector<int> first_together(const std::vector<Point>& x, double apart) {
  std::vector<int> order(x.size()), first(x.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(first.begin(), first.end(), 0);
  const auto at = [&](int k) { return x[std::size_t(k)]; };
  // Sorted along a direction that is not normal to a box's faces: their points would all be equal.
  constexpr Point askew{0.7548, 0.5698, 0.3247};  // its length is at most 1
  const auto along = [&](int k) { return dot(at(k), askew); };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return along(a) != along(b) ? along(a) < along(b) : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i; j-- > 0 && along(order[i]) - along(order[j]) <= apart;) {
      if (norm(at(order[i]) - at(order[j])) > apart) continue;
      int &a = first[std::size_t(order[i])], &b = first[std::size_t(order[j])];
      a = b = std::min(first[std::size_t(a)], first[std::size_t(b)]);
    }
  for (int& f : first)
    while (first[std::size_t(f)] != f) f = first[std::size_t(f)];
  return first;
}

void merge_points(TriangleMesh& mesh, MeshCondition& found) {
  const auto first = first_together(mesh.points, 1e-7 * diagonal_of(mesh));
  std::vector<int> place(mesh.points.size(), -1);
  std::vector<Point> points;
  for (std::size_t k = 0; k < first.size(); ++k)
    if (first[k] == int(k)) {
      place[k] = int(points.size());
      points.push_back(mesh.points[k]);
    }
  found.merged = std::int64_t(mesh.points.size() - points.size());
  mesh.points = std::move(points);
  for (Triangle& t : mesh.triangles)
    for (int& corner : t) corner = place[std::size_t(first[std::size_t(corner)])];
}

void remove_none(TriangleMesh& mesh, MeshCondition& found) {
  std::set<Triangle> seen;
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2]) ++found.degenerate;
    else if (!seen.insert(sorted).second) ++found.doubled;
    else kept.push_back(t);
  }
  mesh.triangles = std::move(kept);
}

/// A triangle at an edge, and whether it passes the edge from the lower to the higher point index.
struct Side {
  int triangle;
  bool upward;
};
using Edges = std::map<std::pair<int, int>, std::vector<Side>>;

Edges edges_of(const TriangleMesh& mesh) {
  Edges edges;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      const int a = mesh.triangles[k][std::size_t(c)],
                b = mesh.triangles[k][std::size_t((c + 1) % 3)];
      edges[{std::min(a, b), std::max(a, b)}].push_back({int(k), a < b});
    }
  return edges;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// The connected shells of a mesh. It turns the triangles of a shell that face opposite to its
/// majority.
class Shells {
 public:
  Shells(TriangleMesh& mesh, const Edges& edges)
      : mesh_(mesh), next_(mesh.triangles.size()), shell_(mesh.triangles.size(), -1) {
    for (const auto& [edge, sides] : edges)
      if (sides.size() == 2) {
        const bool against = sides[0].upward == sides[1].upward;
        next_[std::size_t(sides[0].triangle)].push_back({sides[1].triangle, against});
        next_[std::size_t(sides[1].triangle)].push_back({sides[0].triangle, against});
      }
  }

  std::int64_t turn_consistently() {
    std::int64_t turned = 0;
    for (std::size_t k = 0; k < shell_.size(); ++k)
      if (shell_[k] < 0) turned += turn_minority(int(k));
    return turned;
  }
  /// Turns shells that are inside out, unless they are the hollow of another. Returns the number of
  /// triangles turned.
  std::int64_t turn_outwards() {
    std::int64_t turned = 0;
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (!(volume(shells_[s]) < 0) || is_hollow(s)) continue;
      for (const int k : shells_[s]) turn(mesh_.triangles[std::size_t(k)]);
      turned += std::int64_t(shells_[s].size());
    }
    return turned;
  }

 private:
  std::int64_t turn_minority(int first) {
    const int shell = int(shells_.size());
    std::vector<int> all{first};
    std::vector<bool> against{false};
    shell_[std::size_t(first)] = shell;
    std::int64_t count = 0;
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const auto& [other, turns] : next_[std::size_t(all[k])]) {
        if (shell_[std::size_t(other)] >= 0) continue;
        shell_[std::size_t(other)] = shell;
        all.push_back(other);
        against.push_back(against[k] != turns);
        count += against.back();
      }
    const bool most = 2 * count > std::int64_t(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      if (against[k] != most) turn(mesh_.triangles[std::size_t(all[k])]);
    shells_.push_back(std::move(all));
    return most ? std::int64_t(shells_.back().size()) - count : count;
  }
  /// Six times the volume that a shell encloses; negative if it is inside out [m^3].
  double volume(const std::vector<int>& shell) const {
    const Point origin = mesh_.corners(shell[0])[0];
    double sum = 0;
    for (const int k : shell) {
      const auto [a, b, c] = mesh_.corners(k);
      sum += dot(a - origin, cross(b - origin, c - origin));
    }
    return sum;
  }
  bool is_hollow(std::size_t s) const {
    const auto [a, b, c] = mesh_.corners(shells_[s][0]);
    const Point middle = (a + b + c) / 3;
    double winding = 0;
    for (std::size_t k = 0; k < shell_.size(); ++k)
      if (shell_[k] != int(s)) winding += solid_angle(mesh_.corners(int(k)), middle);
    return std::abs(winding) > 0.5;
  }

  struct Neighbor {
    int triangle;
    bool against;
  };
  TriangleMesh& mesh_;
  std::vector<std::vector<Neighbor>> next_;
  std::vector<int> shell_;
  std::vector<std::vector<int>> shells_;
};

}  // namespace

MeshCondition mend_mesh(TriangleMesh& mesh) {
  MeshCondition found;
  merge_points(mesh, found);
  remove_none(mesh, found);
  const Edges edges = edges_of(mesh);
  for (const auto& [edge, sides] : edges) {
    found.crowded += sides.size() > 2;
    if (sides.size() != 1) continue;
    if (found.open++ == 0)
      found.open_at =
          0.5 * (mesh.points[std::size_t(edge.first)] + mesh.points[std::size_t(edge.second)]);
  }
  Shells shells(mesh, edges);
  found.turned = shells.turn_consistently();
  if (found.closed()) found.turned += shells.turn_outwards();
  return found;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "mesh/fill_holes.h"
#include "mesh/mesh_distance.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;
using Triangle = TriangleMesh::Triangle;

struct Box {
  Point low, high;
};
Box box_around(const TriangleMesh& mesh) {
  Box box{mesh.points[0], mesh.points[0]};
  for (const Point& x : mesh.points) {
    box.low = each(box.low, x, [](double a, double b) { return std::min(a, b); });
    box.high = each(box.high, x, [](double a, double b) { return std::max(a, b); });
  }
  return box;
}

/// Joins points that coincide, closer than `apart` [m]. A cell of points, smaller than that, is
/// joined at once, so that the work does not grow with the square of their number.
class Together {
 public:
  Together(const std::vector<Point>& x, Point low, double apart)
      : x_(x), apart_(apart), order_(x.size()), first_(x.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::iota(first_.begin(), first_.end(), 0);
    find_cells(low);
    join_near_cells();
  }
  /// For each point the lowest index of the points that it is joined with.
  std::vector<int> first() {
    for (std::size_t k = 0; k < first_.size(); ++k) first_[k] = root(int(k));
    return std::move(first_);
  }

 private:
  struct Cell {
    std::size_t from, to;  // of order_
    double along;
  };
  Point at(int k) const { return x_[std::size_t(k)]; }
  int root(int k) {
    while (first_[std::size_t(k)] != k)
      k = first_[std::size_t(k)] = first_[std::size_t(first_[std::size_t(k)])];
    return k;
  }
  void join(int a, int b) {
    a = root(a), b = root(b);
    first_[std::size_t(std::max(a, b))] = std::min(a, b);
  }
  void find_cells(Point low) {
    const double side = apart_ > 0 ? apart_ / 2 : 1;
    std::vector<std::array<double, 3>> cell;
    for (const Point& x : x_)
      cell.push_back({std::floor((x.x - low.x) / side), std::floor((x.y - low.y) / side),
                      std::floor((x.z - low.z) / side)});
    const auto of = [&](int k) { return cell[std::size_t(k)]; };
    std::sort(order_.begin(), order_.end(),
              [&](int a, int b) { return of(a) != of(b) ? of(a) < of(b) : a < b; });
    // Along a direction that is not normal to a box's faces, whose points would all be equal.
    constexpr Point askew{0.7548, 0.5698, 0.3247};  // its length is at most 1
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const bool same = k > 0 && of(order_[k - 1]) == of(order_[k]);
      if (!same) cells_.push_back({k, k, dot(at(order_[k]), askew)});
      cells_.back().to = k + 1;
      join(order_[cells_.back().from], order_[k]);
    }
    std::sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
      return a.along != b.along ? a.along < b.along : a.from < b.from;
    });
  }
  void join_near_cells() {
    const double reach = 3 * apart_;  // of the first points: apart and two diagonals of a cell
    for (std::size_t i = 0; i < cells_.size(); ++i)
      for (std::size_t j = i; j-- > 0 && cells_[i].along - cells_[j].along <= reach;) {
        const int a = order_[cells_[i].from], b = order_[cells_[j].from];
        if (norm(at(a) - at(b)) <= reach && root(a) != root(b) && meet(cells_[i], cells_[j]))
          join(a, b);
      }
  }
  bool meet(const Cell& a, const Cell& b) const {
    for (std::size_t i = a.from; i < a.to; ++i)
      for (std::size_t j = b.from; j < b.to; ++j)
        if (norm(at(order_[i]) - at(order_[j])) <= apart_) return true;
    return false;
  }

  const std::vector<Point>& x_;
  double apart_;
  std::vector<int> order_, first_;
  std::vector<Cell> cells_;
};

void merge_points(TriangleMesh& mesh, MeshCondition& found) {
  const Box box = box_around(mesh);
  const auto first = Together(mesh.points, box.low, 1e-7 * norm(box.high - box.low)).first();
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

OpenEdges open_edges(const TriangleMesh& mesh, const Edges& edges) {
  OpenEdges open;
  for (const auto& [edge, sides] : edges) {
    if (sides.size() != 1) continue;
    const Triangle& t = mesh.triangles[std::size_t(sides[0].triangle)];
    for (std::size_t c = 0; c < 3; ++c)  // the triangle may have been turned
      if (std::minmax(t[c], t[(c + 1) % 3]) == std::minmax(edge.first, edge.second))
        open.emplace_back(t[c], t[(c + 1) % 3]);
  }
  return open;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// The connected shells of a mesh. It turns the triangles of a shell that face opposite to its
/// majority.
class Shells {
 public:
  Shells(TriangleMesh& mesh, const Edges& edges)
      : mesh_(&mesh), next_(mesh.triangles.size()), shell_(mesh.triangles.size(), -1) {
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
      for (const int k : shells_[s]) turn(mesh_->triangles[std::size_t(k)]);
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
      if (against[k] != most) turn(mesh_->triangles[std::size_t(all[k])]);
    shells_.push_back(std::move(all));
    return most ? std::int64_t(shells_.back().size()) - count : count;
  }
  /// Six times the volume that a shell encloses; negative if it is inside out [m^3].
  double volume(const std::vector<int>& shell) const {
    const Point origin = mesh_->corners(shell[0])[0];
    double sum = 0;
    for (const int k : shell) {
      const auto [a, b, c] = mesh_->corners(k);
      sum += dot(a - origin, cross(b - origin, c - origin));
    }
    return sum;
  }
  bool is_hollow(std::size_t s) const {
    const auto [a, b, c] = mesh_->corners(shells_[s][0]);
    const Point middle = (a + b + c) / 3;
    double winding = 0;
    for (std::size_t k = 0; k < shell_.size(); ++k)
      if (shell_[k] != int(s)) winding += solid_angle(mesh_->corners(int(k)), middle);
    return std::abs(winding) > 0.5;
  }

  struct Neighbor {
    int triangle;
    bool against;
  };
  TriangleMesh* mesh_;
  std::vector<std::vector<Neighbor>> next_;
  std::vector<int> shell_;
  std::vector<std::vector<int>> shells_;
};

}  // namespace

MeshCondition mend_mesh(TriangleMesh& mesh, double fill_below) {
  MeshCondition found;
  merge_points(mesh, found);
  remove_none(mesh, found);
  Edges edges = edges_of(mesh);
  for (const auto& [edge, sides] : edges) found.crowded += sides.size() > 2;
  Shells shells(mesh, edges);
  found.turned = shells.turn_consistently();
  OpenEdges open = open_edges(mesh, edges);
  if (!open.empty()) {
    fill_holes(mesh, open, fill_below, found);
    edges = edges_of(mesh);
    shells = Shells(mesh, edges);
    shells.turn_consistently();
    open = open_edges(mesh, edges);
  }
  found.open = std::int64_t(open.size());
  if (found.closed()) found.turned += shells.turn_outwards();
  return found;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "import/mesh_solid.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace freshet {
namespace {

using SolidPoint = Vec<3, double>;
constexpr std::size_t fewest_round = 20;  // points of a sphere or cylinder

bool is_end(double x, double low, double high) {
  const double tolerance = 1e-6 * (high - low);
  return std::abs(x - low) <= tolerance || std::abs(x - high) <= tolerance;
}

/// Whether all points are corners of the box, and each corner is a point.
bool fills_box(const std::vector<SolidPoint>& points, const Bounds& b) {
  const SolidPoint c = b.center();
  std::set<int> corners;
  for (const SolidPoint& p : points) {
    if (!is_end(p.x, b.low.x, b.high.x) || !is_end(p.y, b.low.y, b.high.y) ||
        !is_end(p.z, b.low.z, b.high.z))
      return false;
    corners.insert((p.x > c.x ? 1 : 0) + (p.y > c.y ? 2 : 0) + (p.z > c.z ? 4 : 0));
  }
  return corners.size() == 8;
}

/// The radius of a sphere on which all points are.
std::optional<double> sphere_radius(const std::vector<SolidPoint>& points, const Bounds& b) {
  if (points.size() < fewest_round) return std::nullopt;
  double low = Bounds::far, high = 0;
  for (const SolidPoint& p : points) {
    const double r = norm(p - b.center());
    low = std::min(low, r);
    high = std::max(high, r);
  }
  if (low < 0.99 * high) return std::nullopt;
  return high;
}

/// The radius of a cylinder along y: points between its ends are on its side, and each end has
/// points on its rim.
std::optional<double> cylinder_radius(const std::vector<SolidPoint>& points, const Bounds& b) {
  if (points.size() < fewest_round) return std::nullopt;
  const SolidPoint c = b.center();
  const auto radius = [&](const SolidPoint& p) { return std::hypot(p.x - c.x, p.z - c.z); };
  double high = 0;
  for (const SolidPoint& p : points) high = std::max(high, radius(p));
  std::size_t rims[2] = {};
  for (const SolidPoint& p : points) {
    const bool on_side = radius(p) >= 0.99 * high;
    const bool at_end = is_end(p.y, b.low.y, b.high.y);
    if (!on_side && !at_end) return std::nullopt;
    if (on_side && at_end) ++rims[p.y > c.y];
  }
  if (rims[0] < 8 || rims[1] < 8) return std::nullopt;
  return high;
}

/// The corners of the loops that a plane cuts from a mesh.
class Section {
 public:
  Section(const TriangleMesh& mesh, const Placement& place) {
    for (const SolidPoint& p : mesh.points) points_.push_back(place(p));
    double extent = 0;
    for (const SolidPoint& p : points_) extent = std::max(extent, std::abs(p.z));
    for (SolidPoint& p : points_) p.z += 1e-7 * extent;  // no corner is in the plane
    for (const auto& t : mesh.triangles) cut(t);
  }

  std::vector<std::vector<SolidPoint>> loops(double apart) {
    std::vector<std::vector<SolidPoint>> all;
    while (!next_.empty()) {
      std::vector<SolidPoint> loop = take_loop(apart);
      if (loop.size() >= 3) all.push_back(std::move(loop));
    }
    return all;
  }

 private:
  using Edge = std::pair<int, int>;

  void cut(const TriangleMesh::Triangle& t) {
    std::optional<std::pair<Edge, SolidPoint>> down, up;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const SolidPoint p = points_[std::size_t(a)], q = points_[std::size_t(b)];
      if ((p.z < 0) == (q.z < 0)) continue;
      const std::pair<Edge, SolidPoint> crossing{std::minmax(a, b),
                                                 p + (p.z / (p.z - q.z)) * (q - p)};
      (p.z < 0 ? up : down) = crossing;
    }
    if (down && up) next_[down->first] = {up->first, down->second};
  }
  std::vector<SolidPoint> take_loop(double apart) {
    std::vector<SolidPoint> loop;
    for (auto at = next_.begin(); at != next_.end();) {
      const Edge to = at->second.first;
      const SolidPoint p = at->second.second;
      next_.erase(at);
      if (loop.empty() || norm(p - loop.back()) >= apart) loop.push_back({p.x, p.y, 0});
      at = next_.find(to);
    }
    return loop;
  }

  std::vector<SolidPoint> points_;
  std::map<Edge, std::pair<Edge, SolidPoint>> next_;
};

}  // namespace

MeshSolid solid_of_mesh(const TriangleMesh& mesh, const Vec<3, double>& scale) {
  MeshSolid solid;
  std::vector<SolidPoint> points;
  for (const SolidPoint& p : mesh.points) {
    points.push_back(product_of(scale, p));
    solid.bounds.add(points.back());
  }
  if (fills_box(points, solid.bounds)) {
    solid.kind = MeshSolid::Kind::box;
  } else if (const auto side = cylinder_radius(points, solid.bounds)) {
    solid.kind = MeshSolid::Kind::cylinder;  // the rims alone would be on a sphere, too
    solid.radius = *side;
  } else if (const auto r = sphere_radius(points, solid.bounds)) {
    solid.kind = MeshSolid::Kind::sphere;
    solid.radius = *r;
  }
  return solid;
}

std::vector<std::vector<Vec<3, double>>> section_of_mesh(const TriangleMesh& mesh,
                                                         const Placement& place, double apart) {
  TriangleMesh whole = mesh;
  mend_mesh(whole);  // triangles that meet share their corners
  return Section(whole, place).loops(apart);
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/model/body_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/model/loaded_mesh.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;

constexpr int around = 64;  // corners of a circle

/// A surface of revolution: rings of `around` points about an axis, from its lower to its upper
/// end. Each ring is a distance along the axis and a radius, which is 0 at both ends.
TriangleMesh turned(Point center, Point axis, const std::vector<Vec<2, double>>& rings) {
  const Point side = std::abs(axis.x) < 0.9 ? Point{1, 0, 0} : Point{0, 1, 0};
  Point u = cross(axis, side);
  u = u / norm(u);
  const Point v = cross(axis, u);
  TriangleMesh m;
  for (const auto& ring : rings)
    for (int k = 0; k < around; ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      m.points.push_back(center + ring.x * axis + ring.y * std::cos(angle) * u +
                         ring.y * std::sin(angle) * v);
    }
  const auto at = [](std::size_t ring, int k) { return int(ring) * around + k % around; };
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    for (int k = 0; k < around; ++k) {
      m.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)});
      m.triangles.push_back({at(r, k), at(r + 1, k + 1), at(r + 1, k)});
    }
  mend_mesh(m);  // merges the points of each end
  return m;
}

}  // namespace

TriangleMesh body_mesh(const Scene::Body& b) {
  if (is_mesh(b)) return b.loaded->distance.mesh();
  if (b.shape == Shape::box) return triangles_of_box(vec_of<3>(b.min), vec_of<3>(b.max));
  std::vector<Vec<2, double>> rings;
  if (b.shape == Shape::cylinder)
    rings = {
        {-b.length / 2, 0}, {-b.length / 2, b.radius}, {b.length / 2, b.radius}, {b.length / 2, 0}};
  else
    for (int k = 0; k <= around / 2; ++k) {
      const double angle = std::numbers::pi * k / (around / 2);
      rings.push_back(
          {-b.radius * std::cos(angle), k % (around / 2) ? b.radius * std::sin(angle) : 0.0});
    }
  return turned(vec_of<3>(b.center),
                b.shape == Shape::cylinder ? unit_of<3>(b.axis) : Point{0, 1, 0}, rings);
}

TriangleMesh collision_mesh(const Scene::Body& b) {
  if (is_mesh(b)) return b.loaded->distance.mesh();
  const bool flat = b.shape == Shape::box ? b.min.size() == 2 : b.center.size() == 2;
  return flat ? prism_of(outline_of(b)) : body_mesh(b);
}

std::string encode_obj(const TriangleMesh& mesh, Point origin, const std::string& name) {
  std::string out = fmt::format("# {}, about its centre of mass at the start: {} {} {} [m]\no {}\n",
                                name, origin.x, origin.y, origin.z, name);
  for (const Point& p : mesh.points)
    out += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x - origin.x, p.y - origin.y, p.z - origin.z);
  for (const auto& t : mesh.triangles)
    out += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return out;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/model/body_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/model/body_mesh.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/region_rotation.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

using Point = Vec<3, double>;

Point point_of(const Vector& v) { return {v[0], v[1], v.size() == 3 ? v[2] : 0.0}; }

/// inertia = (trace of s) I - s, where s are the second moments about the centre.
void set_inertia(BodyShape& b, const double (&s)[3][3]) {
  const double trace = s[0][0] + s[1][1] + s[2][2];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) b.inertia[i][j] = (i == j ? trace : 0) - s[i][j];
}

BodyShape box(const Scene::Body& r) {
  BodyShape b;
  double moments[3][3] = {};
  b.volume = 1;
  for (std::size_t k = 0; k < r.min.size(); ++k) b.volume *= r.max[k] - r.min[k];
  for (std::size_t k = 0; k < r.min.size(); ++k)
    moments[k][k] = b.volume * square(r.max[k] - r.min[k]) / 12;
  b.center = 0.5 * (point_of(r.min) + point_of(r.max));
  b.reach = norm(0.5 * (point_of(r.max) - point_of(r.min)));
  set_inertia(b, moments);
  return b;
}

BodyShape ball(const Scene::Body& r) {
  BodyShape b;
  const bool flat = r.center.size() == 2;
  const double a = r.radius, pi = std::numbers::pi;
  b.volume = flat ? pi * a * a : 4 * pi / 3 * a * a * a;
  b.center = point_of(r.center);
  b.reach = a;
  double moments[3][3] = {};
  for (std::size_t k = 0; k < r.center.size(); ++k)
    moments[k][k] = b.volume * a * a / (flat ? 4 : 5);
  set_inertia(b, moments);
  return b;
}

BodyShape cylinder(const Scene::Body& r) {
  BodyShape b;
  const double a = r.radius;
  b.volume = std::numbers::pi * a * a * r.length;
  b.center = point_of(r.center);
  b.reach = std::hypot(a, r.length / 2);
  auto axis = unit_of<3>(r.axis);
  double moments[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      moments[i][j] =
          b.volume * ((i == j ? a * a / 4 : 0) + component(axis, i) * component(axis, j) *
                                                     (r.length * r.length / 12 - a * a / 4));
  set_inertia(b, moments);
  return b;
}

/// Sums over the tetrahedra that the triangles form with one point.
BodyShape mesh(const TriangleMesh& m) {
  BodyShape b;
  const Point from = m.points[0];
  Point first{};
  double second[3][3] = {};
  for (int t = 0; t < int(m.triangles.size()); ++t) {
    auto corners = m.corners(t);
    for (Point& p : corners) p = p - from;
    const double volume = dot(corners[0], cross(corners[1], corners[2])) / 6;
    Point sum = corners[0] + corners[1] + corners[2];
    b.volume += volume;
    first += volume / 4 * sum;
    for (int i = 0; i < 3; ++i)  // of a tetrahedron with a corner at the origin
      for (int j = 0; j < 3; ++j) {
        double products = component(sum, i) * component(sum, j);
        for (Point& p : corners) products += component(p, i) * component(p, j);
        second[i][j] += volume / 20 * products;
      }
  }
  Point c = first / b.volume;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) second[i][j] -= b.volume * component(c, i) * component(c, j);
  b.center = from + c;
  for (const Point& p : m.points) b.reach = std::max(b.reach, norm(p - b.center));
  set_inertia(b, second);
  return b;
}

/// Sums over the triangles that the sides form with one corner.
BodyShape polygon(const Outline& x) {
  BodyShape b;
  Point first{};
  double second[3][3] = {};
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const auto p = x[k] - x[0], q = x[k + 1] - x[0], sum = p + q;
    const double area = (p.x * q.y - p.y * q.x) / 2;
    b.volume += area;
    first += area / 3 * Point{sum.x, sum.y, 0};
    second[0][0] += area / 12 * (p.x * p.x + q.x * q.x + sum.x * sum.x);
    second[1][1] += area / 12 * (p.y * p.y + q.y * q.y + sum.y * sum.y);
  }
  const Point c = first / b.volume;
  second[0][0] -= b.volume * c.x * c.x;
  second[1][1] -= b.volume * c.y * c.y;
  b.center = Point{x[0].x, x[0].y, 0} + c;
  for (const auto& p : x) b.reach = std::max(b.reach, norm(Point{p.x, p.y, 0} - b.center));
  set_inertia(b, second);  // zz needs xx and yy only
  return b;
}

/// A box that is turned about its centre.
BodyShape turned_box(const Scene::Body& r) {
  BodyShape b = box(r);
  if (r.min.size() == 2) return b;
  const RegionRotation turned(r.rotation);
  const double diagonal[] = {b.inertia[0][0], b.inertia[1][1], b.inertia[2][2]};
  Point axes[] = {turned(Point{1, 0, 0}), turned(Point{0, 1, 0}), turned(Point{0, 0, 1})};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      b.inertia[i][j] = 0;
      for (int k = 0; k < 3; ++k)
        b.inertia[i][j] += diagonal[k] * component(axes[k], i) * component(axes[k], j);
    }
  return b;
}

BodyShape of_even_density(const Scene::Body& r) {
  if (r.shape == Shape::sphere) return ball(r);
  if (r.shape == Shape::cylinder) return cylinder(r);
  if (r.shape == Shape::mesh) return mesh(r.loaded->distance.mesh());
  if (r.shape == Shape::polygon) return polygon(r.loaded->outline);
  return is_turned_box(r) ? turned_box(r) : box(r);
}

/// A free tank is a shell: its mass is spread evenly over its surface. Sums over the triangles of
/// the surface, in 2D over the sides of the outline.
void spread_over_surface(const Scene::Body& r, BodyShape& b) {
  std::vector<std::vector<Point>> pieces;
  if (r.velocity.size() == 2) {
    const Outline x = is_mesh(r) ? r.loaded->outline : outline_of(r);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto q = x[(k + 1) % x.size()];
      pieces.push_back({{x[k].x, x[k].y, 0}, {q.x, q.y, 0}});
    }
  } else {
    const TriangleMesh m = body_mesh(r);
    for (int t = 0; t < int(m.triangles.size()); ++t) {
      const auto corners = m.corners(t);
      pieces.emplace_back(corners.begin(), corners.end());
    }
  }
  double total = 0, second[3][3] = {};
  Point first{};
  for (auto& piece : pieces) {
    const double n = double(piece.size());
    Point sum{};
    for (Point& p : piece) sum += p = p - b.center;
    const double size = piece.size() == 2
                            ? norm(piece[1] - piece[0])
                            : norm(cross(piece[1] - piece[0], piece[2] - piece[0])) / 2;
    total += size;
    first += size / n * sum;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        double products = component(sum, i) * component(sum, j);
        for (Point& p : piece) products += component(p, i) * component(p, j);
        second[i][j] += size / (n * (n + 1)) * products;
      }
  }
  Point c = first / total;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      second[i][j] = b.volume * (second[i][j] / total - component(c, i) * component(c, j));
  b.center += c;
  b.reach += norm(c);
  set_inertia(b, second);
}

/// The tensor of the key `inertia`.
void set_inertia(BodyShape& b, const Vector& inertia) {
  auto& i = b.inertia;
  if (inertia.size() == 1) {
    i[2][2] = inertia[0] / b.density();
    return;
  }
  for (std::size_t k = 0; k < 3; ++k) i[k][k] = inertia[k] / b.density();
  const auto beside = [&](std::size_t k) {
    return inertia.size() == 6 ? inertia[k] / b.density() : 0.0;
  };
  i[0][1] = i[1][0] = beside(3);
  i[0][2] = i[2][0] = beside(4);
  i[1][2] = i[2][1] = beside(5);
}

}  // namespace

bool moves_free_bodies() {
#ifdef FRESHET_BULLET
  return true;
#else
  return false;
#endif
}

BodyShape body_shape(const Scene::Body& r) {
  BodyShape b = of_even_density(r);
  if (r.side == Side::inside && r.motion == BodyMotion::free) spread_over_surface(r, b);
  b.middle = b.center;
  b.extent = 2 * b.reach;
  b.mass = r.mass.value_or(r.density.value_or(0) * b.volume);
  if (!r.inertia.empty()) set_inertia(b, r.inertia);
  if (r.center_of_mass.empty()) return b;
  b.center = point_of(r.center_of_mass);
  b.reach += norm(b.center - b.middle);
  return b;
}

std::array<bool, 6> freedoms_of(const Scene::Body& body, int dimension) {
  std::array<bool, 6> free{};
  for (std::size_t k = 0; k < 6; ++k)
    free[k] = (dimension == 3 || k < 2 || k == 5) &&
              std::find(body.lock.begin(), body.lock.end(), Freedom(k)) == body.lock.end();
  return free;
}

}  // namespace freshet

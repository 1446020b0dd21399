// SPDX-License-Identifier: MIT
#include "scene/sample/join_points.h"

#include <algorithm>

#include "scene/sample/point_grid.h"
#include "scene/sample/point_spacing.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;

constexpr double widest = 1.6;  // spacings of the fluid: no liquid fits through a narrower gap
constexpr double diagonal = 1.45, second = 1.99;  // median distances: of a square, of neighbours
constexpr double hair = 1e-6;                     // fraction of a length
constexpr std::size_t many = 100'000;             // points, of which only the nearest are joined

template <int D> Vec<D, double> point_of(const std::vector<double>& x, std::size_t i) {
  Vec<D, double> a{};
  for (int k = 0; k < D; ++k) component(a, k) = x[D * i + std::size_t(k)];
  return a;
}

/// Points, and which of them are near each other.
template <int D> class NearPoints {
 public:
  NearPoints(const std::vector<double>& x, double near) : grid_(near) {
    PointGrid<D> places(hair * near);
    for (std::size_t i = 0; i < x.size() / D; ++i) {
      const auto at = point_of<D>(x, i);
      if (places.comes_near(at)) continue;  // a point that is listed twice
      places.add(at);
      grid_.add(at);
      x_.push_back(at);
    }
    later_.resize(x_.size());
    for (std::size_t i = 0; i < x_.size(); ++i)
      for (const int j : grid_.near(x_[i]))
        if (j > int(i)) later_[i].push_back(j);
  }
  int size() const { return int(x_.size()); }
  Vec<D, double> at(int i) const { return x_[std::size_t(i)]; }
  /// Those near point i that have greater numbers.
  const std::vector<int>& later(int i) const { return later_[std::size_t(i)]; }
  bool are_near(int i, int j) const {
    return std::find(later(i).begin(), later(i).end(), j) != later(i).end();
  }
  /// Whether a ball has more than `own` points closer to its centre than `radius`.
  bool is_occupied(Vec<D, double> center, double radius, int own) const {
    const auto near = grid_.near(center);
    return std::count_if(near.begin(), near.end(),
                         [&](int i) { return norm2(at(i) - center) < radius * radius; }) > own;
  }

 private:
  PointGrid<D> grid_;
  std::vector<Vec<D, double>> x_;
  std::vector<std::vector<int>> later_;
};

/// The smallest circle around a triangle.
struct Circle {
  Point center;
  double radius;
};
Circle circle_around(Point a, Point b, Point c) {
  const Point* corners[] = {&a, &b, &c};
  for (int k = 0; k < 3; ++k) {  // a right or obtuse angle is opposite to a diameter
    const Point p = *corners[k], q = *corners[(k + 1) % 3], r = *corners[(k + 2) % 3];
    if (dot(p - r, q - r) <= 0) return {0.5 * (p + q), norm(p - q) / 2};
  }
  const Point ab = b - a, ac = c - a, n = cross(ab, ac);
  const Point to = (0.5 / norm2(n)) * (norm2(ac) * cross(n, ab) + norm2(ab) * cross(ac, n));
  return {a + to, norm(to)};
}

bool has_area(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Point a = mesh.points[std::size_t(t[0])], ab = mesh.points[std::size_t(t[1])] - a,
              ac = mesh.points[std::size_t(t[2])] - a;
  return norm(cross(ab, ac)) > hair * norm(ab) * norm(ac);
}

/// Triangles whose circles are empty: others would cut corners.
TriangleMesh join_in_3d(const NearPoints<3>& points) {
  TriangleMesh mesh;
  for (int i = 0; i < points.size(); ++i) mesh.points.push_back(points.at(i));
  for (int i = 0; i < points.size(); ++i)
    for (const int j : points.later(i))
      for (const int k : points.later(i)) {
        if (k <= j || !points.are_near(j, k)) continue;
        const TriangleMesh::Triangle t{i, j, k};
        if (!has_area(mesh, t)) continue;
        const Circle around = circle_around(points.at(i), points.at(j), points.at(k));
        if (!points.is_occupied(around.center, (1 - hair) * around.radius, 0))
          mesh.triangles.push_back(t);
      }
  return mesh;
}

/// Strips between points whose circle, with its rim, has no other point.
TriangleMesh join_in_2d(const NearPoints<2>& points, double width) {
  TriangleMesh mesh;
  const int n = points.size();
  for (const double z : {-width, width})
    for (int i = 0; i < n; ++i) mesh.points.push_back({points.at(i).x, points.at(i).y, z});
  for (int i = 0; i < n; ++i)
    for (const int j : points.later(i)) {
      const auto half = 0.5 * (points.at(j) - points.at(i)), middle = points.at(i) + half;
      const double radius = norm(half);
      if (radius == 0 || points.is_occupied(middle, (1 + hair) * radius, 2)) continue;
      mesh.triangles.push_back({i, j, n + j});
      mesh.triangles.push_back({i, n + j, n + i});
    }
  return mesh;
}

}  // namespace

TriangleMesh join_points(const std::vector<double>& x, int dimension, double spacing) {
  const double median = median_spacing(x, dimension);
  const bool is_large = x.size() / std::size_t(dimension) > many;
  double near = widest * spacing;
  if (median > 0) near = std::min(near, (is_large ? diagonal : second) * median);
  return dimension == 2 ? join_in_2d({x, near}, near) : join_in_3d({x, near});
}

}  // namespace freshet

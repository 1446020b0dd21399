// SPDX-License-Identifier: MIT
#include "mesh/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/nearest_on_triangle.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;
using Corners = std::array<Point, 3>;

constexpr int leaf = 4;      // maximum number of triangles of a leaf
constexpr double far = 2.3;  // distance in radii from which a node counts as a dipole

Point least(Point a, Point b) {
  return each(a, b, [](double p, double q) { return std::min(p, q); });
}
Point most(Point a, Point b) {
  return each(a, b, [](double p, double q) { return std::max(p, q); });
}

double distance2(Point low, Point high, Point x) {
  return norm2(most(most(low - x, x - high), Point{}));
}

/// The distance at which a ray meets a triangle, in units of `direction` [Möller and Trumbore
/// 1997].
std::optional<double> hit(const Corners& t, Point from, Point direction) {
  const Point ab = t[1] - t[0], ac = t[2] - t[0], p = cross(direction, ac);
  const double determinant = dot(ab, p);
  if (determinant == 0) return {};
  const Point s = from - t[0], q = cross(s, ab);
  const double u = dot(s, p) / determinant, v = dot(direction, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return {};
  return dot(ac, q) / determinant;
}

constexpr double edge = 1e-9;  // fraction of a triangle's sides by which it is wider for crossings

/// The fraction of the way from one side of a triangle to its other side, or onto it.
std::optional<double> crossing(const Corners& t, Point from, Point to, bool two_sided) {
  const Point ab = t[1] - t[0], ac = t[2] - t[0], n = cross(ab, ac), way = to - from;
  const double before = dot(n, from - t[0]), after = dot(n, to - t[0]);
  if (before == 0 || before * after > 0 || (before < 0 && !two_sided)) return {};
  const double along = before / (before - after);
  const Point x = from + along * way - t[0];
  const double u = dot(cross(x, ac), n) / norm2(n), v = dot(cross(ab, x), n) / norm2(n);
  if (!(u >= -edge && v >= -edge && u + v <= 1 + edge)) return {};
  return along;
}

bool meets_box(Point low, Point high, Point from, Point direction, double until) {
  double enter = 0, leave = until;
  for (int k = 0; k < 3; ++k) {
    const double v = component(direction, k), e = component(from, k);
    if (v == 0) {
      if (e < component(low, k) || e > component(high, k)) return false;
      continue;
    }
    const double a = (component(low, k) - e) / v, b = (component(high, k) - e) / v;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

}  // namespace

double solid_angle(const Corners& t, Point x) {
  const Point a = t[0] - x, b = t[1] - x, c = t[2] - x;
  const double la = norm(a), lb = norm(b), lc = norm(c);
  const double numerator = dot(a, cross(b, c));
  const double denominator = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return std::atan2(numerator, denominator) / (2 * std::numbers::pi);
}

MeshDistance::MeshDistance(TriangleMesh mesh)
    : mesh_(std::move(mesh)), order_(mesh_.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(mesh_.triangles.size());
  build(0, int(order_.size()));
}

MeshDistance::Node MeshDistance::node_around(int first, int count) const {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Node node{{inf, inf, inf}, {-inf, -inf, -inf}, {}, {}, 0, 0, first, count, 0};
  Point mean{};
  for (int k = first; k < first + count; ++k) {
    const auto [a, b, c] = mesh_.corners(order_[std::size_t(k)]);
    node.low = least(node.low, least(a, least(b, c)));
    node.high = most(node.high, most(a, most(b, c)));
    const Point area_normal = 0.5 * cross(b - a, c - a);
    const double area = norm(area_normal);
    node.area_normal += area_normal;
    node.area += area;
    node.center += area / 3 * (a + b + c);
    mean += (a + b + c) / (3.0 * count);
  }
  node.center = node.area > 0 ? node.center / node.area : mean;
  for (int k = first; k < first + count; ++k)
    for (const Point& p : mesh_.corners(order_[std::size_t(k)]))
      node.radius = std::max(node.radius, norm(p - node.center));
  return node;
}

/// Builds the node of `count` triangles from `first` on. It is split at the median along its
/// longest side. Returns the index of the node.
int MeshDistance::build(int first, int count) {
  const int place = int(nodes_.size());
  nodes_.push_back(node_around(first, count));
  if (count <= leaf) return place;
  Point size = nodes_.back().high - nodes_.back().low;
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (component(size, k) > component(size, longest)) longest = k;
  const auto along = [&](int t) {
    auto [a, b, c] = mesh_.corners(t);
    return component(a, longest) + component(b, longest) + component(c, longest);
  };
  const auto from = order_.begin() + first;
  std::nth_element(from, from + count / 2, from + count, [&](int s, int t) {
    const double p = along(s), q = along(t);
    return p != q ? p < q : s < t;
  });
  build(first, count / 2);
  const int second = build(first + count / 2, count - count / 2);
  nodes_[std::size_t(place)].second = second;
  nodes_[std::size_t(place)].count = 0;
  return place;
}

MeshDistance::Nearest MeshDistance::nearest(Point x) const {
  Nearest best{std::numeric_limits<double>::infinity(), {}, -1};
  nearest(0, x, best);
  return best;
}

void MeshDistance::nearest(int place, Point x, Nearest& best) const {
  const Node& node = nodes_[std::size_t(place)];
  if (node.count > 0) {
    for (int k = node.first; k < node.first + node.count; ++k) {
      const int triangle = order_[std::size_t(k)];
      const Point p = nearest_on_triangle(mesh_.corners(triangle), x);
      if (const double d = norm(x - p); d < best.distance) best = {d, p, triangle};
    }
    return;
  }
  int one = place + 1, two = node.second;
  const auto box_distance2 = [&](int n) {
    return distance2(nodes_[std::size_t(n)].low, nodes_[std::size_t(n)].high, x);
  };
  double near = box_distance2(one), other = box_distance2(two);
  if (other < near) {
    std::swap(one, two);
    std::swap(near, other);
  }
  if (near < best.distance * best.distance) nearest(one, x, best);
  if (other < best.distance * best.distance) nearest(two, x, best);
}

double MeshDistance::winding_number(Point x) const { return winding(0, x); }

double MeshDistance::winding(int place, Point x) const {
  const Node& node = nodes_[std::size_t(place)];
  const Point to = node.center - x;
  const double r = norm(to);
  if (r > far * node.radius) return dot(node.area_normal, to) / (4 * std::numbers::pi * r * r * r);
  if (node.count == 0) return winding(place + 1, x) + winding(node.second, x);
  double sum = 0;
  for (int k = node.first; k < node.first + node.count; ++k)
    sum += solid_angle(mesh_.corners(order_[std::size_t(k)]), x);
  return sum;
}

bool MeshDistance::is_inside(Point x) const {
  return distance2(low(), high(), x) == 0 && winding_number(x) > 0.5;
}

double MeshDistance::signed_distance(Point x) const {
  const double d = nearest(x).distance;
  return is_inside(x) ? -d : d;
}

std::optional<double> MeshDistance::first_hit(Point from, Point direction, double at_least) const {
  double first = std::numeric_limits<double>::infinity();
  std::vector<int> open{0};
  while (!open.empty()) {
    const int place = open.back();
    const Node& node = nodes_[std::size_t(place)];
    open.pop_back();
    if (!meets_box(node.low, node.high, from, direction, first)) continue;
    if (node.count == 0) {
      open.push_back(place + 1);
      open.push_back(node.second);
    }
    for (int k = node.first; k < node.first + node.count; ++k)
      if (const auto at = hit(mesh_.corners(order_[std::size_t(k)]), from, direction))
        if (*at > at_least && *at < first) first = *at;
  }
  if (std::isinf(first)) return {};
  return first;
}

std::optional<MeshDistance::Crossing> MeshDistance::first_crossing(Point from, Point to,
                                                                   bool two_sided) const {
  std::optional<Crossing> first;
  const Point low = least(from, to), high = most(from, to);
  std::vector<int> open{0};
  while (!open.empty()) {
    const int place = open.back();
    const Node& node = nodes_[std::size_t(place)];
    open.pop_back();
    const Point slack = edge * (node.high - node.low) + Point{edge, edge, edge};
    bool apart = false;
    for (int k = 0; k < 3; ++k) {
      Point l = low, h = high, nl = node.low - slack, nh = node.high + slack;
      apart |= component(h, k) < component(nl, k) || component(l, k) > component(nh, k);
    }
    if (apart) continue;
    if (node.count == 0) {
      open.push_back(place + 1);
      open.push_back(node.second);
    }
    for (int k = node.first; k < node.first + node.count; ++k) {
      const int triangle = order_[std::size_t(k)];
      const auto at = crossing(mesh_.corners(triangle), from, to, two_sided);
      if (at && (!first || *at < first->along)) first = Crossing{*at, triangle};
    }
  }
  return first;
}

}  // namespace freshet

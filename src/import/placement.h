// SPDX-License-Identifier: MIT
/// Positions of SPlisHSPlasH: scaled, rotated about an axis, translated.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/rotation.h"
#include "core/vec.h"

namespace freshet {

/// A box along the axes that grows around points.
struct Bounds {
  using Point = Vec<3, double>;
  static constexpr double far = std::numeric_limits<double>::infinity();
  Point low{far, far, far}, high{-far, -far, -far};

  bool empty() const { return !(low.x <= high.x); }
  void add(const Point& a) {
    low = {std::min(low.x, a.x), std::min(low.y, a.y), std::min(low.z, a.z)};
    high = {std::max(high.x, a.x), std::max(high.y, a.y), std::max(high.z, a.z)};
  }
  void add(const Bounds& other) {
    if (other.empty()) return;
    add(other.low);
    add(other.high);
  }
  Point center() const { return 0.5 * (low + high); }
  Point size() const { return high - low; }
};

inline Vec<3, double> product_of(const Vec<3, double>& a, const Vec<3, double>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

struct Placement {
  using Point = Vec<3, double>;
  Point scale{1, 1, 1}, axis{0, 0, 1}, translation{};
  double angle = 0;  ///< [rad]

  bool turned() const { return angle != 0 && norm(axis) > 0; }
  bool scales_evenly() const {
    const double tolerance = 1e-6 * std::abs(scale.x);
    return std::abs(scale.x - scale.y) <= tolerance && std::abs(scale.x - scale.z) <= tolerance;
  }
  Point turn(const Point& a) const { return rotation()(a); }
  Point operator()(const Point& a) const { return turn(product_of(scale, a)) + translation; }

  /// The same rotation about x, then y, then z [degrees].
  Point degrees() const {
    const Point x = turn({1, 0, 0}), y = turn({0, 1, 0}), z = turn({0, 0, 1});
    const double about_y = std::asin(std::clamp(-x.z, -1.0, 1.0));
    // Where y is turned by 90 degrees, x and z turn about one line: z stays 0.
    const bool locked = std::abs(x.z) > 1 - 1e-12;
    const double about_x = locked ? std::atan2(-z.y, y.y) : std::atan2(y.z, z.z);
    const double about_z = locked ? 0 : std::atan2(x.y, x.x);
    return 180 / std::numbers::pi * Point{about_x, about_y, about_z};
  }

 private:
  Rotation rotation() const {
    return Rotation(turned() ? rotation_by((angle / norm(axis)) * axis) : rotation_by({0, 0, 0}));
  }
};

}  // namespace freshet

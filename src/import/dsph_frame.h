// SPDX-License-Identifier: MIT
/// Coordinates of DualSPHysics. There z points up; here y does.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/rotation.h"
#include "import/placement.h"

namespace freshet {

/// (x, y, z) of DualSPHysics as (x, z, -y): a rotation, so that turns keep their sense.
inline Vec<3, double> from_dsph(const Vec<3, double>& a) { return {a.x, a.z, -a.y}; }

/// What `move`, `rotate` and `scale` do to what is drawn afterwards.
struct DsphFrame {
  using Point = Vec<3, double>;
  Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, shift{};
  double scale = 1;

  Point turn(const Point& a) const { return a.x * x + a.y * y + a.z * z; }
  Point operator()(const Point& a) const { return shift + scale * turn(a); }
  Point inverse(const Point& p) const {
    const Point a = p - shift;
    return (1 / scale) * Point{dot(a, x), dot(a, y), dot(a, z)};
  }
  bool turned() const { return std::abs(x.x - 1) + std::abs(y.y - 1) + std::abs(z.z - 1) > 1e-9; }
  /// This frame after `inner`.
  DsphFrame of(const DsphFrame& inner) const {
    return {turn(inner.x), turn(inner.y), turn(inner.z), (*this)(inner.shift), scale * inner.scale};
  }
  static DsphFrame moved(const Point& by) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by, 1}; }
  /// A turn about an axis through `center` [rad].
  static DsphFrame turned_by(const Point& axis, double angle, const Point& center) {
    const double length = norm(axis);
    const Rotation r(rotation_by(length > 0 ? (angle / length) * axis : Point{0, 0, 0}));
    DsphFrame f{r({1, 0, 0}), r({0, 1, 0}), r({0, 0, 1}), {}, 1};
    f.shift = center - f.turn(center);
    return f;
  }
  /// The same rotation about x, then y, then z [degrees].
  Point degrees() const {
    const double about_y = std::asin(std::clamp(-x.z, -1.0, 1.0));
    const bool locked = std::abs(x.z) > 1 - 1e-12;
    const double about_x = locked ? std::atan2(-z.y, y.y) : std::atan2(y.z, z.z);
    const double about_z = locked ? 0 : std::atan2(x.y, x.x);
    return 180 / std::numbers::pi * Point{about_x, about_y, about_z};
  }
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Rasterising of closed meshes.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/vec.h"

namespace freshet {

/// A corner in fixed point: 256 steps per sample.
struct FixedPoint {
  static constexpr std::int64_t one = 256;
  static constexpr double farthest = 1 << 20;  ///< maximum coordinate [samples]
  std::int64_t x, y;
};

/// A triangle in fixed point. Arithmetic is exact, and a sample on an edge belongs to the triangle
/// on one side. A ray through a sample therefore enters a closed mesh as often as it leaves it.
class FixedTriangle {
 public:
  explicit FixedTriangle(const std::array<FixedPoint, 3>& corners) : c_(corners) {
    area_ = turn(c_[0], c_[1], c_[2]);
  }
  /// Positive if the corners run clockwise in the picture, whose y points down.
  std::int64_t area() const { return area_; }

  /// Calls f(x, y, shares) for the samples of the triangle in columns 0 to `width` and rows `top`
  /// to `bottom`. `shares` are the barycentric coordinates of the sample's centre.
  template <class F> void each_sample(int width, int top, int bottom, const F& f) const {
    if (area_ == 0) return;
    const auto [left, right] = std::minmax({c_[0].x, c_[1].x, c_[2].x});
    const auto [low, high] = std::minmax({c_[0].y, c_[1].y, c_[2].y});
    const auto cell = [](std::int64_t a, int least, int most) {
      return int(std::clamp<std::int64_t>(a >> 8, least, most));
    };
    const int first = cell(left, 0, width), last = cell(right + FixedPoint::one, 0, width);
    const std::int64_t sign = area_ > 0 ? 1 : -1;
    const double scale = 1 / double(area_);
    for (int y = cell(low, top, bottom); y < cell(high + FixedPoint::one, top, bottom); ++y)
      for (int x = first; x < last; ++x) {
        const FixedPoint p{FixedPoint::one * x + FixedPoint::one / 2,
                           FixedPoint::one * y + FixedPoint::one / 2};
        const std::int64_t a = turn(c_[1], c_[2], p), b = turn(c_[2], c_[0], p), c = area_ - a - b;
        if (holds(sign * a, sign, 1, 2) && holds(sign * b, sign, 2, 0) &&
            holds(sign * c, sign, 0, 1))
          f(x, y, Vec<3, double>{double(a) * scale, double(b) * scale, double(c) * scale});
      }
  }

 private:
  /// Twice the area of a, b, p.
  static std::int64_t turn(FixedPoint a, FixedPoint b, FixedPoint p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  /// Whether a sample at distance `side` from an edge belongs to the triangle. On the edge, the
  /// edge's direction decides.
  bool holds(std::int64_t side, std::int64_t sign, std::size_t from, std::size_t to) const {
    if (side != 0) return side > 0;
    const std::int64_t dx = sign * (c_[to].x - c_[from].x), dy = sign * (c_[to].y - c_[from].y);
    return dy > 0 || (dy == 0 && dx < 0);
  }

  std::array<FixedPoint, 3> c_;
  std::int64_t area_;
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sums of numbers as integer multiples of one unit. They are equal in any order, so they depend
/// neither on threads nor on backends. The unit is the smallest for which n numbers of at most
/// `largest` cannot overflow 63 bits. The error of each number is at most largest · n · 2^-62.
class FixedPoint {
 public:
  FixedPoint(double largest, std::int64_t n) : good_(std::isfinite(largest)) {
    if (good_ && largest > 0 && n > 0)
      unit_ = std::ldexp(1.0, std::ilogb(largest) + 2 + std::ilogb(double(n)) + 1 - 62);
  }
  std::int64_t whole(double value) const {
    return good_ ? std::int64_t(std::nearbyint(value / unit_)) : 0;
  }
  /// The sum as a number; NaN if `largest` is not finite.
  double value(std::int64_t sum) const {
    return good_ ? double(sum) * unit_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  bool good_;
  double unit_ = 1;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sums of numbers as whole multiples of one unit: the same in any order, so that they depend on
/// neither threads nor backends. The unit is the finest for which n numbers of at most `largest`
/// cannot overflow 63 bits: each number is off by at most largest · n · 2^-62.
class FixedPoint {
 public:
  FixedPoint(double largest, std::int64_t n) : good_(std::isfinite(largest)) {
    if (good_ && largest > 0 && n > 0)
      unit_ = std::ldexp(1.0, std::ilogb(largest) + 2 + std::ilogb(double(n)) + 1 - 62);
  }
  std::int64_t whole(double value) const {
    return good_ ? std::int64_t(std::nearbyint(value / unit_)) : 0;
  }
  /// NaN where a number was not finite.
  double value(std::int64_t sum) const {
    return good_ ? double(sum) * unit_ : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  bool good_;
  double unit_ = 1;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

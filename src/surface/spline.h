// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

namespace freshet {

/// The cubic spline [Monaghan 1992] scaled to 1 at its centre, as a function of the squared
/// distance. Sums of it are in units of the value at the centre, so no constant is needed.
struct Spline {
  float inverse;  ///< 1/support radius
  explicit Spline(float support) : inverse(1 / support) {}
  float operator()(float r2) const {
    const float q = std::sqrt(r2) * inverse;
    const float far = std::max(1 - q, 0.0f), near = std::max(0.5f - q, 0.0f);
    return 2 * (far * far * far - 4 * (near * near * near));
  }
  /// The gradient is this times the vector from the particle.
  float slope(float r2) const {
    const float q = std::sqrt(r2) * inverse;
    const float far = std::max(1 - q, 0.0f), near = std::max(1 - 2 * q, 0.0f);
    return -6 * inverse * inverse * (q > 0.5f ? far * far / q : far + near);
  }
};

}  // namespace freshet

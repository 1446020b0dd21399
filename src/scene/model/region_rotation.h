// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <numbers>

#include "core/vec.h"
#include "freshet/vector.h"

namespace freshet {

/// The rotation of a region: in 2D one angle about z, in 3D about x, then y, then z [degrees].
class RegionRotation {
 public:
  explicit RegionRotation(const Vector& degrees) {
    for (std::size_t k = 0; k < degrees.size(); ++k) {
      const std::size_t axis = degrees.size() == 1 ? 2 : k;
      const double angle = degrees[k] * std::numbers::pi / 180;
      cos_[axis] = std::cos(angle);
      sin_[axis] = std::sin(angle);
    }
  }
  Vec<3, double> operator()(Vec<3, double> p) const {
    p = {p.x, cos_[0] * p.y - sin_[0] * p.z, sin_[0] * p.y + cos_[0] * p.z};
    p = {cos_[1] * p.x + sin_[1] * p.z, p.y, cos_[1] * p.z - sin_[1] * p.x};
    return {cos_[2] * p.x - sin_[2] * p.y, sin_[2] * p.x + cos_[2] * p.y, p.z};
  }
  Vec<2, double> operator()(Vec<2, double> p) const {
    return {cos_[2] * p.x - sin_[2] * p.y, sin_[2] * p.x + cos_[2] * p.y};
  }

 private:
  double cos_[3] = {1, 1, 1}, sin_[3] = {0, 0, 0};
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Rotations in three dimensions as unit quaternions x, y, z, w.
#pragma once
#include <array>
#include <cmath>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

using Quaternion = std::array<double, 4>;

/// The rotation p q: first q, then p.
inline Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
          p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
          p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
          p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
}
inline Quaternion inverse(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }

/// The rotation about the direction of `turn` by its length [rad].
inline Quaternion rotation_by(Vec<3, double> turn) {
  const double angle = norm(turn);
  if (!(angle > 0)) return {0, 0, 0, 1};
  const double s = std::sin(angle / 2) / angle;
  return {s * turn.x, s * turn.y, s * turn.z, std::cos(angle / 2)};
}

/// A rotation as a matrix, which is faster for many vectors.
class Rotation {
 public:
  explicit Rotation(const Quaternion& q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    row_[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)};
    row_[1] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)};
    row_[2] = {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)};
  }
  Vec<3, double> operator()(Vec<3, double> a) const {
    return {dot(row_[0], a), dot(row_[1], a), dot(row_[2], a)};
  }
  /// The inverse rotation of a.
  Vec<3, double> inverse(Vec<3, double> a) const {
    return a.x * row_[0] + a.y * row_[1] + a.z * row_[2];
  }

 private:
  Vec<3, double> row_[3];
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Inertia tensors in Bullet, which knows diagonal ones only. Included where Bullet is available.
#pragma once
#include "bodies/colliders.h"

namespace freshet {

/// The axes in which an inertia is diagonal, and its diagonal there.
struct BodyAxes {
  btQuaternion turn;
  btVector3 inertia;
};

/// BodyShape::inertia, along the axes of space after the rotation of the body [m⁵].
inline btMatrix3x3 inertia_of(const BodyShape& shape,
                              const btMatrix3x3& turned = btMatrix3x3::getIdentity()) {
  return turned * bullet(shape.inertia) * turned.transpose();
}

inline BodyAxes principal_axes(btMatrix3x3 inertia) {
  BodyAxes axes;
  btMatrix3x3 principal;
  inertia.diagonalize(principal, 1e-12 * (inertia[0][0] + inertia[1][1] + inertia[2][2]), 100);
  principal.getRotation(axes.turn);
  axes.turn.normalize();
  for (int d = 0; d < 3; ++d) axes.inertia[d] = inertia[d][d];
  return axes;
}

/// A tensor without the elements that couple free axes with locked ones. The inverse of what is
/// left is the mobility about the free axes while the others are held.
inline btMatrix3x3 uncoupled(btMatrix3x3 inertia, const std::array<bool, 6>& free) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j && !(free[std::size_t(3 + i)] && free[std::size_t(3 + j)])) inertia[i][j] = 0;
  return inertia;
}

inline bool turns_freely(const std::array<bool, 6>& free) { return free[3] && free[4] && free[5]; }

}  // namespace freshet

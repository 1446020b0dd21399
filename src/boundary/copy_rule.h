// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A rule that copies particles near a plane: mirror images beyond it (ghosts) or periodic images.
///
///   mirror    x' = x - 2 d n; polar vectors reverse their normal part. With no_slip velocities are
///             reversed completely: the mean velocity of a particle and its ghost is zero
///   periodic  x' = x + shift; all other fields are equal
template <int D> struct CopyRule {
  Vec<D> point, normal;  ///< on the plane [m]; unit, towards the fluid
  Vec<D> shift;          ///< [m]; zero for a mirror
  bool mirror, no_slip;
  int axis;  ///< index of the axis; rules of one axis do not copy each other's copies

  /// Whether x lies on the fluid's side of the plane and closer to it than h [m].
  FRESHET_HD bool near(Vec<D> x, Real h) const {
    const Real d = dot(x - point, normal);
    return d >= 0 && d < h;
  }
  FRESHET_HD Vec<D> position(Vec<D> x) const {
    return mirror ? x - (2 * dot(x - point, normal)) * normal : x + shift;
  }
  FRESHET_HD Vec<D> polar(Vec<D> a) const { return mirror ? a - (2 * dot(a, normal)) * normal : a; }
  FRESHET_HD Vec<D> velocity(Vec<D> v) const { return no_slip ? Real(-1) * v : polar(v); }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

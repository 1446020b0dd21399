// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Copies of particles near a plane: mirror images beyond it (ghosts), or images one period on.
///
///   mirror    x' = x - 2 d n, polar vectors flip their normal part; with no_slip velocities turn
///             round altogether, so that the velocity between a particle and its ghost is zero
///   periodic  x' = x + shift, all else the same
template <int D> struct CopyRule {
  Vec<D> point, normal;  ///< on the plane [m]; unit, towards the fluid
  Vec<D> shift;          ///< [m]; zero for a mirror
  bool mirror, no_slip;
  int axis;  ///< rules of one axis do not act on each other's copies

  /// Whether x, not beyond the plane, is nearer to it than h.
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

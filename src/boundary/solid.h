// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/solid_kind.h"
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The distance to a shape's surface and the normal there.
///
///   center     of the shape, or a point on the plane [m]
///   half       half the sides of a box [m]
///   axis       unit vector along the cylinder, or normal of the plane
///   radius, half_length   of a ball or cylinder [m]
///   fluid_inside          true: the fluid is inside (a tank); false: outside (an obstacle)
template <int D, class R = Real> struct Solid {
  SolidKind kind = SolidKind::box;
  Vec<D, R> center{}, half{}, axis{};
  R radius = 0, half_length = 0;
  bool fluid_inside = false;

  /// The distance of x from the surface [m]: positive on the fluid's side, negative in the wall. It
  /// is exact for a ball and a plane, and on the fluid's side of convex obstacles. Elsewhere it is
  /// the distance from the nearest face.
  FRESHET_HD R distance(Vec<D, R> x) const {
    const R outside = outer_distance(x - center);
    return fluid_inside ? -outside : outside;
  }
  /// The unit normal at the point of the surface nearest to x; it points towards the fluid.
  FRESHET_HD Vec<D, R> normal(Vec<D, R> x) const {
    const Vec<D, R> n = outer_normal(x - center);
    return fluid_inside ? R(-1) * n : n;
  }

 private:
  /// A box and a cylinder are described by overhangs q_k, signed distances from the planes of their
  /// faces: q_k > 0 is beyond face k.
  FRESHET_HD R outer_distance(Vec<D, R> y) const {
    if (kind == SolidKind::plane) return dot(y, axis);
    if (kind == SolidKind::ball) return norm(y) - radius;
    if (kind == SolidKind::cylinder) {
      const R along = dot(y, axis);
      const Vec<2, R> q{norm(y - along * axis) - radius,
                        (along < 0 ? -along : along) - half_length};
      return overhang(q);
    }
    return overhang(box_overhangs(y));
  }
  FRESHET_HD Vec<D, R> outer_normal(Vec<D, R> y) const {
    if (kind == SolidKind::plane) return axis;
    if (kind == SolidKind::ball) return unit(y);
    if (kind == SolidKind::cylinder) {
      const R along = dot(y, axis);
      const Vec<D, R> across = y - along * axis, out = unit(across);
      const Vec<2, R> q{norm(across) - radius, (along < 0 ? -along : along) - half_length};
      const Vec<2, R> n = overhang_normal(q);
      return n.x * out + (along < 0 ? -n.y : n.y) * axis;
    }
    Vec<D, R> n = overhang_normal(box_overhangs(y));
    for (int k = 0; k < D; ++k)
      if (component(y, k) < 0) component(n, k) = -component(n, k);
    return n;
  }
  FRESHET_HD Vec<D, R> box_overhangs(Vec<D, R> y) const {
    Vec<D, R> q{}, side = half;
    for (int k = 0; k < D; ++k) {
      const R a = component(y, k);
      component(q, k) = (a < 0 ? -a : a) - component(side, k);
    }
    return q;
  }
  template <int N> FRESHET_HD static R overhang(Vec<N, R> q) {
    R most = q.x, beyond2 = 0;
    for (int k = 0; k < N; ++k) {
      most = max(most, component(q, k));
      const R b = max(component(q, k), R(0));
      beyond2 += b * b;
    }
    return most > 0 ? sqrt(beyond2) : most;
  }
  template <int N> FRESHET_HD static Vec<N, R> overhang_normal(Vec<N, R> q) {
    Vec<N, R> n{};
    int deepest = 0;
    for (int k = 1; k < N; ++k)
      if (component(q, k) > component(q, deepest)) deepest = k;
    if (!(component(q, deepest) > 0)) {
      component(n, deepest) = 1;
      return n;
    }
    for (int k = 0; k < N; ++k) component(n, k) = max(component(q, k), R(0));
    return unit(n);
  }
  template <int N> FRESHET_HD static Vec<N, R> unit(Vec<N, R> a) {
    const R length = norm(a);
    Vec<N, R> up{};
    up.x = 1;
    return length > 0 ? a / length : up;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

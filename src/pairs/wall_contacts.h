// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sums over boundary particles: the weight w = 1 - r/spacing, which is about 1/2 on the surface of
/// a wall and grows into it; w x_ij [m], a normal; and w u, the wall's velocity [m/s].
template <int D, class R> struct WallContact {
  R weight{};
  Vec<D, R> x{}, u{};
  FRESHET_HD WallContact& operator+=(const WallContact& o) {
    weight += o.weight;
    x += o.x;
    u += o.u;
    return *this;
  }
};
template <int D> struct WallContacts {
  Real spacing;
  Field<Vec<D>> u;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { Vec<D, R> u; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {u[j]}; }
  template <class R>
  FRESHET_HD WallContact<D, R> operator()(const Pair<D, R>& ij, At<R>, const Neighbor<R>& j) const {
    const R w = max(R(1) - ij.r / R(spacing), R(0));
    return {w, w * ij.x, w * j.u};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

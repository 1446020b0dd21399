// SPDX-License-Identifier: MIT
#pragma once
#include "kernels/wendland.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// WendlandC2, C4 or C6, chosen when a run starts. It is one compiled type for all three. A pair
/// takes a few operations more than with the separate kernels.
///
///   h      support radius [m], h > 0;   order  2, 4 or 6
///   W      [1/m^D];  gradient [1/m^(D+1)], zero at the centre;  both zero from h on
template <int D> struct WendlandSmooth {
  Real h, inv_h, c, g;
  Real u4, u6, u8;  // W = c (u4 + u6 (1 - q)^2 + u8 (1 - q)^4) (1 - q)^4 (1 + p1 q + ...)
  Real p1, p2, p3, d1, d2;
  WendlandSmooth(Real h, int order) : h(h), inv_h(1 / h) {
    const int k = order / 2 - 1;
    const auto of_order = [k](auto c2, auto c4, auto c6) {
      return k == 0 ? Real(c2) : k == 1 ? Real(c4) : Real(c6);
    };
    c = (D == 2 ? of_order(7, 9, 78 / 7.0) : of_order(10.5, 495 / 32.0, 1365 / 64.0)) /
        (pi * std::pow(h, D));
    g = of_order(-20, -56 / 3.0, -22) * c / (h * h);
    u4 = of_order(1, 0, 0), u6 = of_order(0, 1, 0), u8 = of_order(0, 0, 1);
    p1 = of_order(4, 6, 8), p2 = of_order(0, 35 / 3.0, 25), p3 = of_order(0, 0, 32);
    d1 = of_order(0, 5, 7), d2 = of_order(0, 0, 16);
  }

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    const R v = square(w.u);
    return c * square(v) * (u4 + v * (u6 + v * u8)) * (1 + w.q * (p1 + w.q * (p2 + p3 * w.q)));
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    const R v = square(w.u);
    return (g * w.u) * v * (u4 + v * (u6 + v * u8)) * (1 + w.q * (d1 + d2 * w.q)) * ij.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "kernels/wendland.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// WendlandC4 or WendlandC6, whichever is asked for when a run starts: one compiled kernel for
/// both, a few operations a pair slower than either.
///
///   h      support radius [m], h > 0;   order  4 or 6
///   W [1/m^D], gradient [1/m^(D+1)]: those of the kernel of that order
template <int D> struct WendlandSmooth {
  Real h, inv_h, c, g;
  Real one, square_of_u;  // (1 - q)^6 (one + square_of_u (1 - q)^2)
  Real p1, p2, p3, d1, d2;
  WendlandSmooth(Real h, int order) : h(h), inv_h(1 / h) {
    const bool c4 = order == 4;
    const Real volume = pi * std::pow(h, D);
    c = (c4 ? D == 2 ? Real(9) : Real(495) / 32 : D == 2 ? Real(78) / 7 : Real(1365) / 64) / volume;
    g = (c4 ? -Real(56) / 3 : Real(-22)) * c / (h * h);
    one = c4, square_of_u = !c4;
    p1 = c4 ? Real(6) : Real(8);
    p2 = c4 ? Real(35) / 3 : Real(25);
    p3 = c4 ? Real(0) : Real(32);
    d1 = c4 ? Real(5) : Real(7);
    d2 = c4 ? Real(0) : Real(16);
  }

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    const R u2 = square(w.u);
    return c * u2 * square(u2) * (one + square_of_u * u2) *
           (1 + w.q * (p1 + w.q * (p2 + p3 * w.q)));
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    const R u2 = square(w.u);
    return (g * w.u) * square(u2) * (one + square_of_u * u2) * (1 + w.q * (d1 + d2 * w.q)) * ij.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

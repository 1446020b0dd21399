// SPDX-License-Identifier: MIT
/// Wendland's kernels [Wendland 1995], with the constants of Dehnen & Aly 2012, table 1. Their form
/// is equal in 2D and 3D; the constant c differs. The gradient is a polynomial in r/h times x_ij:
/// it is smooth at the centre and needs no division. Particles under these kernels do not form
/// pairs. C4 and C6 need wider supports than C2.
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// q = r/h and u = 1 - q, clamped to q = 1 and u = 0 for r >= h: powers stay finite for any r.
template <class R> struct Wendland {
  R q, u;
  FRESHET_HD Wendland(Real h, Real inv_h, R r) {
    const R inside = min(r, R(h));
    q = inside * inv_h;
    u = (h - inside) * inv_h;  // exactly zero at h; 1 - q may differ from zero by rounding
  }
};

/// W(r) = c (1 - q)^4 (1 + 4q), q = r/h < 1, else 0;  c = 7/(pi h^2) in 2D, 21/(2 pi h^3) in 3D
/// [Dehnen & Aly 2012, table 1];  grad W(x_ij) = -20 c/h^2 (1 - q)^3 x_ij.
///
///   h         support radius [m], h > 0
///   W         [1/m^D];  gradient [1/m^(D+1)], zero at the centre;  both zero from h on
template <int D> struct WendlandC2 {
  Real h, inv_h, c, g;
  explicit WendlandC2(Real h)
      : h(h),
        inv_h(1 / h),
        c((D == 2 ? 7 : Real(10.5f)) / (pi * std::pow(h, D))),
        g(-20 * c / (h * h)) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    return c * square(square(w.u)) * (1 + 4 * w.q);
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    return (g * w.u) * square(w.u) * ij.x;
  }
};

/// W(r) = c (1 - q)^6 (3 + 18q + 35q^2)/3, q = r/h < 1, else 0;  c = 9/(pi h^2) in 2D,
/// 495/(32 pi h^3) in 3D [Dehnen & Aly 2012, table 1];
/// grad W(x_ij) = -56/3 c/h^2 (1 - q)^5 (1 + 5q) x_ij
///
///   h         support radius [m], h > 0; use 3 spacings or more
///   W         [1/m^D];  gradient [1/m^(D+1)], zero at the centre;  both zero from h on
template <int D> struct WendlandC4 {
  Real h, inv_h, c3, g;
  explicit WendlandC4(Real h)
      : h(h),
        inv_h(1 / h),
        c3((D == 2 ? 3 : Real(165) / 32) / (pi * std::pow(h, D))),
        g(-56 * c3 / (h * h)) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    const R u2 = square(w.u);
    return c3 * u2 * square(u2) * (3 + w.q * (18 + 35 * w.q));
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    return (g * w.u) * square(square(w.u)) * (1 + 5 * w.q) * ij.x;
  }
};

/// W(r) = c (1 - q)^8 (1 + 8q + 25q^2 + 32q^3), q = r/h < 1, else 0;  c = 78/(7 pi h^2) in 2D,
/// 1365/(64 pi h^3) in 3D [Dehnen & Aly 2012, table 1];
/// grad W(x_ij) = -22 c/h^2 (1 - q)^7 (1 + 7q + 16q^2) x_ij
///
///   h         support radius [m], h > 0; use 3 spacings or more
///   W         [1/m^D];  gradient [1/m^(D+1)], zero at the centre;  both zero from h on
template <int D> struct WendlandC6 {
  Real h, inv_h, c, g;
  explicit WendlandC6(Real h)
      : h(h),
        inv_h(1 / h),
        c((D == 2 ? Real(78) / 7 : Real(1365) / 64) / (pi * std::pow(h, D))),
        g(-22 * c / (h * h)) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    return c * square(square(square(w.u))) * (1 + w.q * (8 + w.q * (25 + 32 * w.q)));
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const Wendland<R> w(h, inv_h, ij.r);
    const R u2 = square(w.u);
    return (g * w.u) * u2 * square(u2) * (1 + w.q * (7 + 16 * w.q)) * ij.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

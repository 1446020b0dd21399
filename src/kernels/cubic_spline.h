// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// W(r) = c ((h - r)_+^3 - 4 (h/2 - r)_+^3), (a)_+ = max(a, 0);  c = 80/(7 pi h^5) in 2D,
/// 16/(pi h^6) in 3D
/// [Monaghan 1992: M4, whose smoothing length is h/2; the two cubes are its two pieces].
///
/// grad W(x_ij) = -3c ((h - r)_+ + (h - 2r)_+) min((h - r)_+/r, 1) x_ij
///
/// The gradient is the factored difference of two squares. For r <= h/2 the minimum is 1, so there
/// is no pole at the centre.
///
///   h         support radius [m], 1e-6 m or more, so that float's c is finite
///   W         [1/m^D];  gradient [1/m^(D+1)], zero at the centre;  both zero from h on
template <int D> struct CubicSpline {
  Real h, c;
  explicit CubicSpline(Real h)
      : h(h), c(D == 2 ? 80 / (7 * pi * std::pow(h, 5)) : 16 / (pi * std::pow(h, 6))) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const R d = max(h - ij.r, R(0)), e = max(h / 2 - ij.r, R(0));
    return c * (d * d * d - 4 * (e * e * e));
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const R d = max(h - ij.r, R(0)), e = max(h - 2 * ij.r, R(0));
    return -3 * c * (d + e) * min(d / ij.r, R(1)) * ij.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

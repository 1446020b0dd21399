// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// grad W(x_ij) = -c (h - r)^2 x_ij/r for r < h, else 0;  c = 30/(pi h^5) in 2D, 45/(pi h^6) in 3D
/// [Mueller 2003, eq. 21: W = (c/3)(h - r)^3]. The gradient does not vanish for r -> 0, so pressure
/// separates particles that are close.
///
///   h         support radius [m], h > 0
///   gradient  [1/m^(D+1)]; zero within 1e-6 m and 1e-4 h of the centre, where its direction is
///             undefined
///   factor    numerator of c over pi h^(D+3): 30 (2D) or 45 (3D) for the derivative of W. The
///             article uses 10 in 2D, a third of the derivative.
template <int D> struct Spiky {
  static constexpr Real derivative = D == 2 ? 30 : 45;
  Real h, c;
  explicit Spiky(Real h, Real factor = derivative) : h(h), c(factor / (pi * std::pow(h, D + 3))) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const R d = max(h - ij.r, R(0));
    return c / 3 * d * d * d;
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    const R d = max(h - ij.r, R(0));
    const Real least = min(Real(1e-6f), Real(1e-4f) * h);
    return select(ij.r > R(least), -c * d * d / ij.r, R(0)) * ij.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

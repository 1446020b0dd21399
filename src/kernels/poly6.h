// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// W(r) = c (h^2 - r^2)^3 for r < h, else 0;  c = 4/(pi h^8) in 2D, 315/(64 pi h^9) in 3D
/// [Mueller 2003, eq. 20; the 2D constant makes the integral over the disc 1].
///
///   h  support radius [m], h > 0;   W [1/m^D];   no square root is taken.
template <int D> struct Poly6 {
  Real h2, c;
  explicit Poly6(Real h)
      : h2(h * h), c(D == 2 ? 4 / (pi * std::pow(h, 8)) : 315 / (64 * pi * std::pow(h, 9))) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    const R d = max(h2 - ij.r2, R(0));
    return c * d * d * d;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

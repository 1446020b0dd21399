// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// lap W(r) = c (h - r) for r < h, else 0;  c = 40/(pi h^5) in 2D, 45/(pi h^6) in 3D
/// [Mueller 2003, eq. 22]. It is never negative, so viscosity never adds energy.
///
///   h  support radius [m], h > 0;   laplacian [1/m^(D+2)]
template <int D> struct ViscosityKernel {
  Real h, c;
  explicit ViscosityKernel(Real h) : h(h), c((D == 2 ? 40 : 45) / (pi * std::pow(h, D + 3))) {}

  template <class R> FRESHET_HD R laplacian(const Pair<D, R>& ij) const {
    return c * max(h - ij.r, R(0));
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// dv_i/dt += sum_k K x_ik/|x_ik|^2 W(|x_ik|/h)  over the boundary particles of a wall
/// W(q) = 1.77/32 (1 + 5/2 q + 2 q^2) (2 - q)^5  for q < 2, else 0
/// [Monaghan and Kajtar 2009, eq. 3.1, with the fluid's spacing (beta = 1) and mass in walls]
///
///   strength  K [m^2/s^2], about g times the depth;   h  half the support [m];  the sum in m/s^2
template <int D> struct Monaghan2009Repulsion {
  Real strength, h;
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int) const { return {}; }
  template <class R> FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, At<R>, At<R>) const {
    const R q = ik.r / h, u = max(2 - q, R(0)), u2 = u * u;
    const R W = Real(1.77f / 32) * (1 + Real(2.5f) * q + 2 * q * q) * (u2 * u2 * u);
    return (strength * W / max(ik.r2, R(Real(1e-4f) * h * h))) * ik.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

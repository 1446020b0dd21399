// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// rho_i = sum_j m W_ij, j = i included  [Mueller 2003, eq. 3]
///
///   m  mass over the kernel's lattice sum [kg/m^(3-D)]: a resting lattice has its rest density;
///      the sum in kg/m^3
template <int D, template <int> class Kernel> struct Density {
  Kernel<D> W;
  Real m;
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int) const { return {}; }
  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij, At<R>, At<R>) const {
    return m * W(ij);
  }
};
// clang before 17 deduces no aggregates: one guide per term.
template <int D, template <int> class K, class... A> Density(K<D>, A...) -> Density<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

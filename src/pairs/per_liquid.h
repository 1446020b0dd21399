// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A number for each liquid, indexed by particle. `kind` has no memory for one liquid.
struct PerLiquid {
  static constexpr int most = 8;
  Real of[most];
  Field<int> kind;
  FRESHET_HD Real operator[](int i) const { return of[kind.data ? kind[i] : 0]; }
};

/// mu_ij = 2 mu_i mu_j/(mu_i + mu_j): the mean with equal stress on both sides of an interface
/// [Cleary and Monaghan 1999]. 0 if both are 0.
template <class R> FRESHET_HD R shared_viscosity(R mu_i, R mu_j) {
  return 2 * mu_i * mu_j / max(mu_i + mu_j, R(Real(1e-30f)));
}

}  // namespace FRESHET_ISA
}  // namespace freshet

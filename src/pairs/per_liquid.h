// SPDX-License-Identifier: MIT
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// mu_ij = 2 mu_i mu_j/(mu_i + mu_j): of equal stress on both sides [Cleary and Monaghan 1999]
template <class R> FRESHET_HD R shared_viscosity(R mu_i, R mu_j) {
  return 2 * mu_i * mu_j / max(mu_i + mu_j, R(Real(1e-30f)));
}

}  // namespace FRESHET_ISA
}  // namespace freshet

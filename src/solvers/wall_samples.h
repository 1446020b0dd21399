// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/wall_sets.h"
#include "pairs/akinci2012.h"
#include "solvers/backend.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// psi of all samples of akinci2012, once. Sorts the samples.
template <int D, class B, class Kernel, class Parameters>
void prepare_walls(B& backend, Walls<D>& walls, const Kernel& W, const Parameters& c) {
  auto& wall = walls.akinci2012;
  if (wall.n == 0) return;
  backend.find_neighbors("walls", c.support, wall);
  const auto psi = wall.psi;
  const Real rho0 = c.rho0;
  backend.sum_pairs("walls", wall, over(wall, Akinci2012Volume{W}),
                    [=] FRESHET_LAMBDA(int k, Real sum) { psi[k] = rho0 / sum; });
}

}  // namespace FRESHET_ISA
}  // namespace freshet

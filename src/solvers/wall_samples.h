// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/wall_sets.h"
#include "pairs/akinci2012.h"
#include "solvers/backend.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Computes psi [kg/m^(3-D)] of all boundary particles of akinci2012, at the start. Sorts them.
/// Reads their volume factors in psi.
template <int D, class B, class Kernel>
void prepare_walls(B& backend, Walls<D>& walls, const Kernel& W, Real support, Real rho0) {
  auto& wall = walls.akinci2012;
  if (wall.n == 0) return;
  backend.find_neighbors("walls", support, wall);
  const auto psi = wall.psi;
  backend.sum_pairs("walls", wall, over(wall, Akinci2012Volume{W}),
                    [=] FRESHET_LAMBDA(int k, Real sum) { psi[k] *= rho0 / sum; });
}

}  // namespace FRESHET_ISA
}  // namespace freshet

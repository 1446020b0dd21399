// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// sum_j W(x_j) dx^D over the square (cubic) lattice of spacing dx, the origin included: what a
/// density sum yields, over the rest density, inside a resting lattice. 1 for a fine lattice; its
/// distance from 1 is the kernel's lattice error at this ratio of support to spacing.
///
///   spacing, support_radius  [m], > 0;  cost (2 support/spacing + 1)^D kernel calls.
template <int D, class Kernel>
double lattice_sum(const Kernel& W, double spacing, double support_radius) {
  const int m = int(support_radius / spacing) + 1, mz = D == 3 ? m : 0;
  double sum = 0;
  for (int kz = -mz; kz <= mz; ++kz)
    for (int ky = -m; ky <= m; ++ky)
      for (int kx = -m; kx <= m; ++kx) {
        Vec<D> x{};
        x.x = Real(kx * spacing);
        x.y = Real(ky * spacing);
        if constexpr (D == 3) x.z = Real(kz * spacing);
        sum += double(W(Pair<D, Real>(x)));
      }
  return sum * std::pow(spacing, D);
}

}  // namespace FRESHET_ISA
}  // namespace freshet

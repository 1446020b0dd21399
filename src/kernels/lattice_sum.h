// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// sum_j W(x_j) over the plane of the lattice that lies so many spacings from the origin.
template <int D, class Kernel>
double layer_sum(const Kernel& W, double spacing, double support_radius, double away) {
  const int m = int(support_radius / spacing) + 1, mz = D == 3 ? m : 0;
  double sum = 0;
  for (int kz = -mz; kz <= mz; ++kz)
    for (int kx = -m; kx <= m; ++kx) {
      Vec<D> x{};
      x.x = Real(kx * spacing);
      x.y = Real(away * spacing);
      if constexpr (D == 3) x.z = Real(kz * spacing);
      sum += double(W(Pair<D, Real>(x)));
    }
  return sum;
}

/// sum_j W(x_j) dx^D over the square (cubic) lattice of spacing dx, the origin included: what a
/// density sum yields, over the rest density, inside a resting lattice. 1 for a fine lattice; its
/// distance from 1 is the kernel's lattice error at this ratio of support to spacing.
///
///   spacing, support_radius  [m], > 0;  cost (2 support/spacing + 1)^D kernel calls.
template <int D, class Kernel>
double lattice_sum(const Kernel& W, double spacing, double support_radius) {
  const int m = int(support_radius / spacing) + 1;
  double sum = 0;
  for (int layer = -m; layer <= m; ++layer) sum += layer_sum<D>(W, spacing, support_radius, layer);
  return sum * std::pow(spacing, D);
}

/// How many spacings away from a lattice that fills a half space one layer of samples, as dense and
/// of volume 1/sum_l W_kl each, stands for the other half: the lattice then has its rest density up
/// to the wall.
template <int D, class Kernel>
double single_layer_distance(const Kernel& W, double spacing, double support_radius) {
  const auto layer = [&](double away) { return layer_sum<D>(W, spacing, support_radius, away); };
  double missing = 0;
  for (int k = 1; k * spacing < support_radius; ++k) missing += layer(k);
  const double wanted =
      layer(0) * missing * std::pow(spacing, D) / lattice_sum<D>(W, spacing, support_radius);
  double near = 1, far = support_radius / spacing;
  for (int step = 0; step < 40; ++step) {
    const double middle = (near + far) / 2;
    (layer(middle) > wanted ? near : far) = middle;
  }
  return near;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

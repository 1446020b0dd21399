// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Calls f(x) for each point x [m] of the square (cubic) lattice in a cube around the origin that
/// covers the support.
template <int D, class F> void on_lattice(double spacing, double support_radius, F f) {
  const int m = int(support_radius / spacing) + 1, mz = D == 3 ? m : 0;
  for (int kz = -mz; kz <= mz; ++kz)
    for (int ky = -m; ky <= m; ++ky)
      for (int kx = -m; kx <= m; ++kx) {
        Vec<D> x{};
        x.x = Real(kx * spacing);
        x.y = Real(ky * spacing);
        if constexpr (D == 3) x.z = Real(kz * spacing);
        f(x);
      }
}

/// The mean of r under a kernel: the integral of r W(r) over all space [m], by the midpoint rule.
/// The mean distance from a plane through the centre is 2/pi times this in 2D, half of it in 3D.
template <int D, class Kernel> double mean_distance(const Kernel& W, double support_radius) {
  constexpr int shells = 1000;
  const double dr = support_radius / shells;
  double sum = 0;
  for (int k = 0; k < shells; ++k) {
    const double r = (k + 0.5) * dr;
    Vec<D> x{};
    x.x = Real(r);
    const double shell = D == 2 ? 2 * double(pi) * r : 4 * double(pi) * r * r;
    sum += r * double(W(Pair<D, Real>(x))) * shell * dr;
  }
  return sum;
}

/// sum_j |grad W(x_j)|^2 over a lattice [1/m^(2D + 2)]. In 3D a float's squares overflow at
/// spacings of micrometres and underflow at 100 km, so gradients are divided by a power of two
/// before.
template <int D, class Kernel>
double lattice_response(const Kernel& W, double spacing, double support_radius) {
  Vec<D> aside{};
  aside.x = Real(spacing);
  const Real typical = W.gradient(Pair<D, Real>(aside)).x;
  const int exponent = typical < 0 ? std::ilogb(typical) : 0;
  double sum = 0;
  on_lattice<D>(spacing, support_radius, [&](Vec<D> x) {
    Vec<D> g = W.gradient(Pair<D, Real>(x));
    for (int d = 0; d < D; ++d) component(g, d) = std::ldexp(component(g, d), -exponent);
    sum += double(norm2(g));
  });
  return std::ldexp(sum, 2 * exponent);
}

/// What a flat free surface lacks: (1 - rho/rho0) R/|sum_j grad W(x_j)|^2 in the outermost layer of
/// a lattice that fills a half space, with R = lattice_response. The sum of gradients is zero
/// inside the fluid and grows with what lacks on one side.
template <int D, class Kernel>
double surface_deficit(const Kernel& W, double spacing, double support_radius) {
  double all = 0, there = 0;
  Vec<D, double> push{};
  on_lattice<D>(spacing, support_radius, [&](Vec<D> x) {
    const double weight = double(W(Pair<D, Real>(x)));
    all += weight;
    if (x.y > 0) return;
    there += weight;
    Vec<D> gradient = W.gradient(Pair<D, Real>(x));
    for (int d = 0; d < D; ++d) component(push, d) += double(component(gradient, d));
  });
  return (1 - there / all) * lattice_response<D>(W, spacing, support_radius) / norm2(push);
}

/// The largest eigenvalue of the pressure equations on an infinite lattice over their diagonal:
/// max over waves k of |sum_j grad W(x_j) sin(k · x_j)|^2/sum_j |grad W(x_j)|^2. A relaxed Jacobi
/// iteration converges if its relaxation factor is below 2 over this number.
template <int D, class Kernel>
double lattice_stiffness(const Kernel& W, double spacing, double support_radius) {
  constexpr int waves = 12;  // per axis; the shortest has a wavelength of two spacings
  double most = 0;
  for (int wave = 0; wave < (D == 3 ? waves * waves * waves : waves * waves); ++wave) {
    Vec<D, double> g{}, k{};
    for (int d = 0, rest = wave; d < D; ++d, rest /= waves)
      component(k, d) = double(pi) * (rest % waves + 1) / (waves * spacing);
    on_lattice<D>(spacing, support_radius, [&](Vec<D> x) {
      Vec<D> gradient = W.gradient(Pair<D, Real>(x));
      double phase = 0;
      for (int d = 0; d < D; ++d) phase += component(k, d) * double(component(x, d));
      for (int d = 0; d < D; ++d)
        component(g, d) += double(component(gradient, d)) * std::sin(phase);
    });
    most = std::max(most, norm2(g));
  }
  return most / lattice_response<D>(W, spacing, support_radius);
}

/// sum_j W(x_j) over a lattice plane at a distance of `away` spacings from the origin [1/m^D].
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

/// sum_j W(x_j) dx^D over the square (cubic) lattice of spacing dx, the origin included: the
/// density sum inside a resting lattice over the rest density. It tends to 1 for a fine lattice.
/// Its difference from 1 is the kernel's lattice error at this ratio of support to spacing.
///
///   spacing, support_radius  [m], > 0;  cost (2 support/spacing + 1)^D kernel calls
template <int D, class Kernel>
double lattice_sum(const Kernel& W, double spacing, double support_radius) {
  const int m = int(support_radius / spacing) + 1;
  double sum = 0;
  for (int layer = -m; layer <= m; ++layer) sum += layer_sum<D>(W, spacing, support_radius, layer);
  return sum * std::pow(spacing, D);
}

/// A single layer of boundary particles in place of the missing half of a lattice that fills a half
/// space. The layer has the lattice's spacing. It is right if the density sum of the outermost
/// lattice layer is the rest density.
template <int D, class Kernel> class SingleLayer {
 public:
  SingleLayer(const Kernel& W, double spacing, double support_radius)
      : W_(W), spacing_(spacing), support_(support_radius) {
    double missing = 0;
    for (int k = 1; k * spacing < support_radius; ++k) missing += layer(k);
    const double sum = lattice_sum<D>(W, spacing, support_radius);
    wanted_ = layer(0) * missing * std::pow(spacing, D) / sum;
    alone_ = double(W(Pair<D, Real>(Vec<D>{}))) * std::pow(spacing, D) / sum;
  }
  /// The volumes of its particles over 1/sum_l W_kl, for a layer `away` spacings from the lattice.
  /// A particle alone in the layer must be compressed, or else it would stay there or pass through:
  /// its density is at least 1.05 times the rest density.
  double volume_factor(double away) const {
    return std::max(wanted_ / layer(away), std::min(1.0, 1.05 - alone_));
  }
  /// The distance [spacings] at which the factor is 1, by bisection.
  double distance() const {
    double near = 1, far = support_ / spacing_;
    for (int step = 0; step < 40; ++step) {
      const double middle = (near + far) / 2;
      (layer(middle) > wanted_ ? near : far) = middle;
    }
    return near;
  }

 private:
  double layer(double away) const { return layer_sum<D>(W_, spacing_, support_, away); }

  const Kernel& W_;
  double spacing_, support_, wanted_;
  double alone_;  // the density of a lone particle over the rest density
};

}  // namespace FRESHET_ISA
}  // namespace freshet

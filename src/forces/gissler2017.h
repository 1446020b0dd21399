// SPDX-License-Identifier: MIT
#pragma once
#include "forces/force.h"
#include "pairs/gissler2017.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The drag of air on what it meets of a liquid [Gissler, Band, Peer, Ihmsen, Teschner 2017]. A
/// particle without neighbours is a drop that the air flattens as the Taylor analogy breakup model
/// has it [O'Rourke and Amsden 1987]; one with many is a piece of a surface. In 2D a particle is as
/// much of a slice one metre deep.
///
///   drop        f = 1/2 rho_a |v_rel|^2 C A exposed/m against v_rel, v_rel = v - wind  [eq. 1]
///   L           radius of a drop as large as the particle [m]
///   y           flattening, 0 for a ball and at most 1 for a disc  [eqs. 5 to 8]
template <int D> struct Gissler2017Drop {
  Air<D> air;
  Real h, spacing, L, m;
  Real flatten;   ///< y over v_rel^2 [s^2/m^2]
  Real full;      ///< number of neighbours from which a particle counts as inside
  Real reynolds;  ///< Re over |v_rel| [s/m]

  /// rho0 [kg/m^3], mu [Pa s], sigma [N/m] of the liquid; inside: neighbours in a resting lattice.
  Gissler2017Drop(const Air<D>& air, double h, double spacing, double rho0, double mu, double sigma,
                  double inside)
      : air(air), h(Real(h)), spacing(Real(spacing)), m(Real(rho0 * std::pow(spacing, D))) {
    const double volume = std::pow(spacing, D), four_pi = 4 * 3.14159265358979323846;
    const double radius =
        D == 3 ? std::cbrt(3 * volume / four_pi) : std::sqrt(4 * volume / four_pi);
    const double C_F = 1.0 / 3, C_k = 8, C_d = 5, C_b = 0.5;
    const double per_td = C_d * mu / (2 * rho0 * radius * radius);
    const double omega2 = C_k * sigma / (rho0 * std::pow(radius, 3)) - per_td * per_td;
    L = Real(radius);
    // The flattening is largest after half a period of the drop's oscillation. An overdamped drop
    // is flattest at rest.
    double most = 1;
    if (omega2 > 0) {
      const double omega = std::sqrt(omega2), t = 3.14159265358979323846 / omega;
      most = 1 + std::exp(-t * per_td);
    }
    flatten = Real(C_F / (C_k * C_b) * double(air.rho) * radius / sigma * most);
    full = Real(2 * inside / 3);
    reynolds = Real(2 * double(air.rho) * radius / double(air.mu));
  }

  auto neighbors(const FluidParticles<D>& f) const {
    return Gissler2017Neighbor<D>{h, air.wind, f.v};
  }

  /// The drag coefficient of a ball [Liu, Mather, Reitz 1993; eq. 3] times Re, which is finite at
  /// rest.
  FRESHET_HD static Real sphere_times_re(Real re) {
    const Real root = cube_root(re);
    return re > 1000 ? Real(0.424f) * re : 24 * (1 + root * root / 6);
  }
  /// The cube root by Newton's iteration, whose bits do not depend on the C library.
  FRESHET_HD static Real cube_root(Real a) {
    if (!(a > Real(1e-12f))) return 0;
    Real y = sqrt(sqrt(a));
    for (int k = 0; k < 8; ++k) y = (2 * y + a / (y * y)) / 3;
    return y;
  }

  FRESHET_HD Vec<D> acceleration(Vec<D> v, const Gissler2017Exposure<D, Real>& seen) const {
    const Vec<D> v_rel = v - air.wind;
    const Real speed = norm(v_rel), inside = min(seen.neighbors / full, Real(1));
    const Real y = min(flatten * speed * speed, Real(1)), re = reynolds * speed;
    const Real flat = 1 + Real(2.632f) * y;
    // C |v_rel|, with C of a drop by Re and C = 1 of a surface [eqs. 4 and 9]
    const Real of_drop = sphere_times_re(re) * flat / reynolds;
    const Real C_v = (1 - inside) * of_drop + inside * speed;
    const Real l = L * (1 + y / 2);
    const Real A_drop = D == 3 ? pi * l * l : 2 * l,
               A_inside = D == 3 ? spacing * spacing : spacing;
    const Real A = ((1 - inside) * A_drop + inside * A_inside) * (1 - min(seen.hidden, Real(1)));
    return (Real(-0.5f) * air.rho * C_v * A / m) * v_rel;  // eqs. 10, 14 and 16
  }
};

/// The drag on the particles of one liquid.
template <int D, class B, template <int> class Kernel> struct Gissler2017 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  Gissler2017Drop<D> drop;
  Gissler2017(const ForceParameters<D>& c, Kernel<D>)
      : drop(c.air, double(c.support), std::pow(double(c.m / c.rho0), 1.0 / D),
             double(c.rho0 / c.liquids[0].lightness), double(c.liquids[0].mu),
             double(c.liquids[0].sigma), double(c.neighbors_inside)) {}
  static bool acts(const ForceParameters<D>& c) { return c.drag == Drag::gissler2017; }

  void add(B& backend, const Fluid& fluid, const Walls<D>&, Real, Field<Vec<D>> push) override {
    const auto f = fluid;
    const auto drop = this->drop;
    backend.sum_pairs("air", f, over(f, drop.neighbors(f)),
                      [=] FRESHET_LAMBDA(int i, const Gissler2017Exposure<D, Real>& seen) {
                        push[i] += drop.acceleration(f.v[i], seen);
                      });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

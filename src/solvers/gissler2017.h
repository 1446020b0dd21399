// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "pairs/gissler2017.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The air: its density [kg/m^3], dynamic viscosity [Pa s] and velocity [m/s].
template <int D> struct Air {
  Real rho, mu;
  Vec<D> wind;
};

/// The drag of air on the exposed part of a liquid [Gissler, Band, Peer, Ihmsen, Teschner 2017]. A
/// particle without neighbours is a drop that the air flattens, by the Taylor analogy breakup model
/// [O'Rourke and Amsden 1987]. A particle with many neighbours is a piece of a surface. In 2D a
/// particle is a bar of one metre length.
///
///   drop        f = 1/2 rho_a |v_rel|^2 C A exposed/m against v_rel, v_rel = v - wind  [eq. 1]
///   L           radius of a drop with the particle's volume [m]
///   y           flattening, 0 for a ball, 1 (the maximum) for a disc  [eqs. 5 to 8]
template <int D> struct Gissler2017 {
  Air<D> air;
  Real h, spacing, L, m;
  Real flatten;   ///< y over v_rel^2 [s^2/m^2]
  Real full;      ///< number of neighbours from which a particle counts as inside
  Real reynolds;  ///< Re over |v_rel| [s/m]

  /// h [m]: support radius; spacing [m]; rho0 [kg/m^3], mu [Pa s], sigma [N/m] of the liquid;
  /// inside: number of neighbours in a resting lattice.
  Gissler2017(const Air<D>& air, double h, double spacing, double rho0, double mu, double sigma,
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

}  // namespace FRESHET_ISA
}  // namespace freshet

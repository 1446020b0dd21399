// SPDX-License-Identifier: MIT
/// Pair terms of versatile surface tension and adhesion for SPH fluids [Akinci, Akinci, Teschner
/// 2013].
///
/// Lengths are in units of the support radius h and masses in units of rho0 h^D, so gamma has one
/// unit in 2D and 3D: m/s^2. In the paper the cohesion term has one factor of mass more than the
/// normal term, so their ratio depends on the units. Here the normal term is scaled by 0.1: drops
/// in 3D then do not burst (docs/forces.md).
#pragma once
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// gamma/(sigma/(rho0 h^2)), with h the support radius. The values are measured at a support of 2
/// spacings (docs/forces.md).
template <int D> constexpr double akinci2013_gamma = D == 2 ? 42 : 56;

/// n_i = h sum_j m/rho_j grad W_ij, towards the fluid  [sec. 3.2]
///
///   h, m [m, kg/m^(3-D)];  reads rho [kg/m^3];  the sum is dimensionless, and zero inside
template <int D, template <int> class Kernel> struct Akinci2013Normal {
  Kernel<D> W;
  Real h, m;
  Field<Real> rho;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R volume; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {m / rho[j]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, At<R>, const Neighbor<R>& j) const {
    return (h * j.volume) * W.gradient(ij);
  }
};
template <int D, template <int> class K, class... A>
Akinci2013Normal(K<D>, A...) -> Akinci2013Normal<D, K>;

/// C(q) = 32/pi (1 - q)^3 q^3 for 1/2 < q <= 1, 32/pi (2 (1 - q)^3 q^3 - 1/64) for q <= 1/2;
/// q = r/h, at most 1  [eq. 2]
template <class R> FRESHET_HD R akinci2013_cohesion(R q) {
  const R u = max(1 - q, R(0)), c = u * u * u * (q * q * q);
  const R near = 2 * c - R(Real(1) / 64);
  return Real(32) / pi * select(q > R(Real(0.5f)), c, near);
}
/// A(q) = 0.007 (-4 q^2 + 6 q - 2)^(1/4) for 1/2 <= q <= 1, else 0;  q = r/h  [eq. 7]
template <class R> FRESHET_HD R akinci2013_adhesion(R q) {
  const R u = max(R(6) * q - R(4) * q * q - R(2), R(0));
  return Real(0.007f) * sqrt(sqrt(u));
}

constexpr Real akinci2013_share = Real(0.1f);  ///< factor s of the normal term

/// f_i = -sum_j gamma_ij 2 rho0/(rho_i + rho_j) m/(rho0 h^D)
///               (C(|x_ij|/h) x_ij/|x_ij| + s (n_i - n_j))  [eqs. 1, 3, 4 and 5]
///
/// with gamma_ij = (gamma_i + gamma_j)/2 and s = akinci2013_share. It conserves momentum.
///
///   gamma [m/s^2], m_h = m/(rho0 h^D);  reads rho [kg/m^3] and n;  the sum in m/s^2
template <int D> struct Akinci2013Tension {
  Real h, rho0, m_h;
  PerLiquid gamma;
  Field<Real> rho;
  Field<Vec<D>> n;
  template <class R> struct At {
    R gamma, rho;
    Vec<D, R> n;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {gamma[i], rho[i], n[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    const R q = min(ij.r / h, R(1));
    const R within = select(q < R(1), R(1), R(0));
    const R K = within * (i.gamma + j.gamma) * (rho0 * m_h) / (i.rho + j.rho);
    const R C = akinci2013_cohesion(q) / max(ij.r, R(Real(1e-30f)));
    return (-K) * (C * ij.x + R(akinci2013_share) * (i.n - j.n));
  }
};

/// f_i = -sum_k beta psi_k/(rho0 h^D) A(|x_ik|/h) x_ik/|x_ik|  over boundary particles  [eq. 6]
///
///   h [m], beta [m/s^2], psi [kg/m^(3-D)];  the sum in m/s^2
template <int D> struct Akinci2013Adhesion {
  Real h, per_mass;  ///< per_mass = 1/(rho0 h^D) [m^(3-D)/kg]
  PerLiquid beta;
  Field<Real> psi;
  template <class R> struct At { R beta; };
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int i) const { return {beta[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k] * per_mass}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R A = akinci2013_adhesion(min(ik.r / h, R(1)));
    return (-i.beta * k.psi * A / max(ik.r, R(Real(1e-30f)))) * ik.x;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Pair terms of the viscosity of Smoothed particle hydrodynamics [Monaghan 2005]. The force acts
/// along the line of each pair. The implicit solver of Weiler 2018 uses the same terms.
#pragma once
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// f_i = sum_j 2 m mu_ij/(rho_i rho_j) (D + 2) (v_ij · x_ij)/(|x_ij|^2 + eps) grad W_ij
/// [sec. 8, with the factor of a divergence-free flow in D dimensions; Weiler, Koschier, Brand,
/// Bender 2018, eq. 5]
///
/// It approximates mu lap v/rho. It conserves momentum and angular momentum.
///
///   m [kg/m^(3-D)], mu [Pa s], eps_h2 1e-4 h^2 [m^2] with h half the support
///   reads rho [kg/m^3] (> 0) and v, any field of velocities [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Monaghan2005Viscosity {
  Kernel<D> W;
  Real m, eps_h2;
  PerLiquid mu;
  Field<Real> rho;
  Field<Vec<D>> v;
  template <class R> struct At {
    R mu, inv_rho;
    Vec<D, R> v;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {mu[i], 1 / rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    const R along = Real(D + 2) * dot(i.v - j.v, ij.x) / (ij.r2 + eps_h2);
    return (2 * m * shared_viscosity(i.mu, j.mu) * i.inv_rho * j.inv_rho * along) * W.gradient(ij);
  }
};
template <int D, template <int> class K, class... A>
Monaghan2005Viscosity(K<D>, A...) -> Monaghan2005Viscosity<D, K>;

/// f_i += sum_k 2 psi_k friction_k mu_i/rho_i^2 (D + 2) (v_i · x_ik)/(|x_ik|^2 + eps) grad W_ik
///
/// The viscosity of Monaghan 2005 at boundary particles at rest, of mass psi_k, density rho_i and
/// viscosity mu_i.
///
///   psi [kg/m^(3-D)], friction 1 for no slip, 0 for free slip, mu [Pa s], eps_h2 1e-4 h^2 [m^2]
///   reads rho [kg/m^3] (> 0), v [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Monaghan2005Akinci {
  Kernel<D> W;
  Real eps_h2;
  PerLiquid mu;
  Field<Real> rho;
  Field<Vec<D>> v;
  Field<Real> psi, friction;
  template <class R> struct At {
    R mu_rho2;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int i) const { return {mu[i] / square(rho[i]), v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k] * friction[k]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R along = Real(2 * (D + 2)) * dot(i.v, ik.x) / (ik.r2 + eps_h2);
    return (k.psi * i.mu_rho2 * along) * W.gradient(ik);
  }
};
template <int D, template <int> class K, class... A>
Monaghan2005Akinci(K<D>, A...) -> Monaghan2005Akinci<D, K>;

/// f_i += sum_k 2 m friction_k mu_i/(rho_i rho0) (D + 2) (v_ik · x_ik)/(|x_ik|^2 + eps) grad W_ik
///
/// The viscosity of Monaghan 2005 at the layers of walls, of mass m, density rho0 and viscosity
/// mu_i. They move with `v_wall`, the extrapolated velocity of the fluid [Adami 2012, eq. 23], or
/// are at rest if `at_rest` is true.
///
///   m [kg/m^(3-D)], rho0 [kg/m^3], friction 1 for no slip, 0 for free slip, mu [Pa s]
///   eps_h2 1e-4 h^2 [m^2];  reads rho [kg/m^3] (> 0), v [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Monaghan2005Adami {
  Kernel<D> W;
  Real m, rho0, eps_h2;
  PerLiquid mu;
  Field<Real> rho;
  Field<Vec<D>> v;
  Field<Real> friction;
  Field<Vec<D>> v_wall;
  bool at_rest;
  template <class R> struct At {
    R mu_rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R friction;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {mu[i] / rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const {
    return {friction[k], at_rest ? Vec<D>{} : v_wall[k]};
  }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R along = Real(2 * (D + 2)) * dot(i.v - k.v, ik.x) / (ik.r2 + eps_h2);
    return (k.friction * m / rho0 * i.mu_rho * along) * W.gradient(ik);
  }
};
template <int D, template <int> class K, class... A>
Monaghan2005Adami(K<D>, A...) -> Monaghan2005Adami<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

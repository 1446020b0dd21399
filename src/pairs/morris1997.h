// SPDX-License-Identifier: MIT
/// Pair terms of the viscosity of Modeling low Reynolds number incompressible flows using SPH
/// [Morris, Fox, Zhu 1997].
#pragma once
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// f_i = sum_j 2 m mu_ij/(rho_i rho_j) (x_ij · grad W_ij)/(|x_ij|^2 + eps) v_ij  [eq. 22]
///
/// It approximates mu lap v/rho for any divergence of v. It conserves momentum, but not angular
/// momentum.
///
///   m [kg/m^(3-D)], mu [Pa s], eps_h2 1e-4 h^2 [m^2] with h half the support
///   reads rho [kg/m^3] (> 0), v [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Morris1997Viscosity {
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
    const R slope = dot(ij.x, W.gradient(ij)) / (ij.r2 + eps_h2);
    return (2 * m * shared_viscosity(i.mu, j.mu) * i.inv_rho * j.inv_rho * slope) * (i.v - j.v);
  }
};
template <int D, template <int> class K, class... A>
Morris1997Viscosity(K<D>, A...) -> Morris1997Viscosity<D, K>;

/// f_i += sum_k 2 psi_k friction_k mu_i/rho_i^2 (x_ik · grad W_ik)/(|x_ik|^2 + eps) v_i
///
/// The viscosity of Morris 1997 at boundary particles at rest, of mass psi_k, density rho_i and
/// viscosity mu_i.
///
///   psi [kg/m^(3-D)], friction 1 for no slip, 0 for free slip, mu [Pa s], eps_h2 1e-4 h^2 [m^2]
///   reads rho [kg/m^3] (> 0), v [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Morris1997Akinci {
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
    const R slope = dot(ik.x, W.gradient(ik)) / (ik.r2 + eps_h2);
    return (2 * k.psi * i.mu_rho2 * slope) * i.v;
  }
};
template <int D, template <int> class K, class... A>
Morris1997Akinci(K<D>, A...) -> Morris1997Akinci<D, K>;

/// f_i += sum_k 2 m friction_k mu_i/(rho_i rho0) (x_ik · grad W_ik)/(|x_ik|^2 + eps) v_ik
///
/// The viscosity of Morris 1997 at the layers of walls, of mass m, density rho0 and viscosity mu_i.
/// Their velocity v_wall is extrapolated from the fluid, as in the paper [eqs. 20 and 21; Adami
/// 2012].
///
///   m [kg/m^(3-D)], rho0 [kg/m^3], friction 1 for no slip, 0 for free slip, mu [Pa s]
///   eps_h2 1e-4 h^2 [m^2];  reads rho [kg/m^3] (> 0), v, v_wall [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Morris1997Adami {
  Kernel<D> W;
  Real m, rho0, eps_h2;
  PerLiquid mu;
  Field<Real> rho;
  Field<Vec<D>> v;
  Field<Real> friction;
  Field<Vec<D>> v_wall;
  template <class R> struct At {
    R mu_rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R friction;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {mu[i] / rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {friction[k], v_wall[k]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R slope = dot(ik.x, W.gradient(ik)) / (ik.r2 + eps_h2);
    return (2 * k.friction * m / rho0 * i.mu_rho * slope) * (i.v - k.v);
  }
};
template <int D, template <int> class K, class... A>
Morris1997Adami(K<D>, A...) -> Morris1997Adami<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

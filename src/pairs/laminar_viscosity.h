// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// a_i = sum_j 2m/(rho_i + rho_j) (2 (D + 2) nu (v_ij · x_ij)/(|x_ij|^2 + eps) grad W_ij
///                                 - xsph/dt v_ij W_ij)
///
/// The first part is nu lap v [Monaghan 2005, with the factor of a divergence-free flow in D
/// dimensions], the second takes each particle a share of the way to its neighbours' mean velocity
/// [Monaghan 1989, XSPH as Schechter and Bridson 2012 have it]. Both conserve momentum, the first
/// its moment as well.
///
///   m [kg], nu [m^2/s], eps_h2 0.01 h^2 [m^2], xsph_rate xsph/dt [1/s];  reads rho, v
template <int D, template <int> class Kernel> struct LaminarViscosity {
  Kernel<D> W;
  Real m, nu, eps_h2, xsph_rate;
  Field<Real> rho;
  Field<Vec<D>> v;
  template <class R> struct At {
    R rho;
    Vec<D, R> v;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    const Vec<D, R> v_ij = i.v - j.v;
    const R along = 2 * (D + 2) * nu * dot(v_ij, ij.x) / (ij.r2 + eps_h2);
    return (2 * m / (i.rho + j.rho)) * (along * W.gradient(ij) - (xsph_rate * W(ij)) * v_ij);
  }
};
template <int D, template <int> class K, class... A>
LaminarViscosity(K<D>, A...) -> LaminarViscosity<D, K>;

/// The same of the samples of a wall at rest, as heavy as psi and as dense as the particle.
template <int D, template <int> class Kernel> struct Akinci2012Friction {
  Kernel<D> W;
  Real nu, eps_h2;
  Field<Real> rho;
  Field<Vec<D>> v;
  Field<Real> psi, friction;
  template <class R> struct At {
    R inv_rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int i) const { return {1 / rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k] * friction[k]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R along = 2 * (D + 2) * nu * dot(i.v, ik.x) / (ik.r2 + eps_h2);
    return (k.psi * i.inv_rho * along) * W.gradient(ik);
  }
};
template <int D, template <int> class K, class... A>
Akinci2012Friction(K<D>, A...) -> Akinci2012Friction<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

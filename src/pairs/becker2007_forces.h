// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Pi_ij = -nu_ij min(v_ij · x_ij, 0)/(|x_ij|^2 + eps h^2),  nu_ij = 2 alpha h c/(rho_i + rho_j)
/// [Becker and Teschner 2007, eq. 11, with eps = 0.01; Monaghan 1992]
///
/// Artificial viscosity. It acts on particles that approach each other. It conserves momentum and
/// angular momentum.
///
///   two_alpha_h_c  2 alpha h c with h half the support [m^2/s];   eps_h2  0.01 h^2 [m^2]
struct ArtificialViscosity {
  Real two_alpha_h_c, eps_h2;
  template <int D, class R>
  FRESHET_HD R operator()(const Pair<D, R>& ij, const Vec<D, R>& v_ij, R rho_i, R rho_j) const {
    const R approach = min(dot(v_ij, ij.x), R(0));
    return -two_alpha_h_c * approach / ((ij.r2 + eps_h2) * (rho_i + rho_j));
  }
};

/// dv_i/dt = -sum_j m (p_i/rho_i^2 + p_j/rho_j^2 + Pi_ij) grad W_ij
/// [Becker and Teschner 2007, eqs. 6 and 10]
///
///   m [kg/m^(3-D)];  reads p [Pa], rho [kg/m^3] (> 0), v [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Becker2007Forces {
  Kernel<D> W;
  ArtificialViscosity Pi;
  Real m;
  Field<Real> p, rho;
  Field<Vec<D>> v;

  template <class R> struct At {
    R p_rho2, rho;
    Vec<D, R> v;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {p[i] / square(rho[i]), rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    const R Pi_ij = Pi(ij, i.v - j.v, i.rho, j.rho);
    return (-m * (i.p_rho2 + j.p_rho2 + Pi_ij)) * W.gradient(ij);
  }
};
template <int D, template <int> class K, class... A>
Becker2007Forces(K<D>, A...) -> Becker2007Forces<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"
#include "pairs/reaction.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The sums of delta-SPH: an acceleration [m/s^2] and a density rate [kg/(m^3 s)].
template <int D, class R> struct DeltaSphSum {
  Vec<D, R> a{};
  R drho{};
  FRESHET_HD DeltaSphSum& operator+=(const DeltaSphSum& o) {
    a += o.a;
    drho += o.drho;
    return *this;
  }
};
template <int D, class R> FRESHET_HD Vec<D, R> acceleration(const DeltaSphSum<D, R>& sum) {
  return sum.a;
}

/// The parameters that all terms of delta-SPH share.
///
///   m, rho0        mass [kg/m^(3-D)], rest density [kg/m^3]
///   alpha_h_c      alpha h c0 of the artificial viscosity [m^2/s];  h half the support
///   delta_h_c      delta h c0 of the density diffusion [m^2/s]
///   eps_h2         0.01 h^2, keeps divisions by |x_ij|^2 finite [m^2]
struct DeltaSphNumbers {
  Real m, rho0, alpha_h_c, delta_h_c, eps_h2;
};

/// drho_i/dt = rho_i sum_j V_j v_ij · grad W_ij + delta h c0 sum_j V_j psi_ij · grad W_ij
/// psi_ij    = 2 (rho_j - rho_i - G · x_ji) x_ji/|x_ij|^2
/// dv_i/dt   = 1/rho_i sum_j V_j (alpha h c0 rho0 pi_ij - p_i - p_j) grad W_ij
/// pi_ij     = v_ij · x_ij/|x_ij|^2,  V_j = m/rho_j
/// [Antuono, Colagrossi, Marrone, Molteni 2010, eq. 10; Fourtakas, Dominguez, Vacondio, Rogers
/// 2019, eq. 14: G is the slope of the hydrostatic density, rho0 g/c0^2 to first order]
///
///   G [kg/m^4];  reads p [Pa], rho [kg/m^3] (> 0), v [m/s];  sums in m/s^2, kg/(m^3 s)
template <int D, template <int> class Kernel> struct DeltaSphRates {
  Kernel<D> W;
  DeltaSphNumbers c;
  Vec<D> G;
  Field<Real> p, rho;
  Field<Vec<D>> v;

  template <class R> struct At {
    R p, rho;
    Vec<D, R> v;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {p[i], rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD DeltaSphSum<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                          const At<R>& j) const {
    const Vec<D, R> dW = W.gradient(ij), v_ij = i.v - j.v;
    const R V_over_rho = c.m / (i.rho * j.rho), V = V_over_rho * i.rho;
    const R inverse_r2 = 1 / (ij.r2 + c.eps_h2);
    const R slope = dot_uniform(G, ij.x);  // -G · x_ji
    const R diffusion = -2 * c.delta_h_c * (j.rho - i.rho + slope) * dot(ij.x, dW) * inverse_r2;
    const R pi_ij = dot(v_ij, ij.x) * inverse_r2;
    return {(V_over_rho * (c.alpha_h_c * c.rho0 * pi_ij - i.p - j.p)) * dW,
            V * (i.rho * dot(v_ij, dW) + diffusion)};
  }

 private:
  template <class R> FRESHET_HD static R dot_uniform(Vec<D> a, const Vec<D, R>& x) {
    if constexpr (D == 3) return a.x * x.x + a.y * x.y + a.z * x.z;
    else return a.x * x.x + a.y * x.y;
  }
};
template <int D, template <int> class K, class... A>
DeltaSphRates(K<D>, A...) -> DeltaSphRates<D, K>;

/// The rates of delta-SPH over the layers of wall particles w [Adami 2012]:
///
///   drho_i/dt += rho_i sum_w V v_i · grad W_iw
///   dv_i/dt   += 1/rho_i sum_w V (alpha h c0 rho0 friction_w pi_iw - max(p_i, 0) - p_w) grad W_iw
///
/// with V = m/rho0 and the extrapolated pressure p_w and velocity v_w. Walls have no density
/// diffusion and never attract. The density rate is that of walls at rest; Adami2012MovingRate
/// corrects it.
///
///   reads p, p_wall [Pa], rho [kg/m^3] (> 0), v, v_wall [m/s]; friction 1 no slip, 0 free slip
template <int D, template <int> class Kernel> struct DeltaSphAdamiRates {
  Kernel<D> W;
  DeltaSphNumbers c;
  Field<Real> p, rho;
  Field<Vec<D>> v;
  Field<Real> p_wall, friction;
  Field<Vec<D>> v_wall;
  template <class R> struct At {
    R p, rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R p, friction;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {p[i], rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int w) const { return {p_wall[w], friction[w], v_wall[w]}; }
  template <class R>
  FRESHET_HD DeltaSphSum<D, R> operator()(const Pair<D, R>& iw, const At<R>& i,
                                          const Neighbor<R>& w) const {
    const Vec<D, R> dW = W.gradient(iw);
    const R pi_iw = w.friction * dot(i.v - w.v, iw.x) / (iw.r2 + c.eps_h2);
    const R V = c.m / c.rho0;
    return {(V * (c.alpha_h_c * c.rho0 * pi_iw - max(i.p, R(0)) - w.p) / i.rho) * dW,
            V * i.rho * dot(i.v, dW)};
  }
};
template <int D, template <int> class K, class... A>
DeltaSphAdamiRates(K<D>, A...) -> DeltaSphAdamiRates<D, K>;

/// The rates of delta-SPH over boundary particles k that mirror the particle's pressure [Akinci
/// 2012]:
///
///   drho_i/dt += rho_i sum_k V_k v_ik · grad W_ik,  V_k = psi_k/rho0
///   dv_i/dt   += 1/rho_i sum_k V_k (alpha h c0 rho0 friction_k pi_ik - 2 max(p_i, 0)) grad W_ik
///
///   psi [kg/m^(3-D)];  reads p [Pa], rho [kg/m^3] (> 0), v, v_wall [m/s]; friction 0 for free slip
template <int D, template <int> class Kernel> struct DeltaSphAkinciRates {
  Kernel<D> W;
  DeltaSphNumbers c;
  Field<Real> p, rho;
  Field<Vec<D>> v;
  Field<Real> psi, friction;
  Field<Vec<D>> v_wall;
  template <class R> struct At {
    R p, rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R V, friction;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {p[i], rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const {
    return {psi[k] / c.rho0, friction[k], v_wall[k]};
  }
  template <class R>
  FRESHET_HD DeltaSphSum<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                          const Neighbor<R>& k) const {
    const Vec<D, R> dW = W.gradient(ik);
    const Vec<D, R> v_ik = i.v - k.v;
    const R pi_ik = k.friction * dot(v_ik, ik.x) / (ik.r2 + c.eps_h2);
    return {(k.V * (c.alpha_h_c * c.rho0 * pi_ik - 2 * max(i.p, R(0))) / i.rho) * dW,
            k.V * i.rho * dot(v_ik, dW)};
  }
};
template <int D, template <int> class K, class... A>
DeltaSphAkinciRates(K<D>, A...) -> DeltaSphAkinciRates<D, K>;

/// Wraps a term that yields an acceleration, such as a wall's repulsion, as a DeltaSphSum with a
/// density rate of zero.
template <int D, class TermT> struct AsRates {
  TermT term;
  template <class R> using At = typename TermT::template At<R>;
  template <class R> using Neighbor = typename TermT::template Neighbor<R>;
  FRESHET_HD At<Real> at(int i) const { return term.at(i); }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return term.neighbor(k); }
  template <class R>
  FRESHET_HD DeltaSphSum<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                          const Neighbor<R>& k) const {
    return {term(ik, i, k), R(0)};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

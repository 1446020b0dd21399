// SPDX-License-Identifier: MIT
/// Pair terms of the transport velocity [Adami, Hu, Adams 2013].
#pragma once
#include "core/fluid_particles.h"
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The sums for the push of a uniform pressure and for the detection of the free surface.
template <int D, class R> struct Adami2013Sums {
  Vec<D, R> push{};   ///< sum_j (V_i^2 + V_j^2) grad W_ij  [m^(D-1)]
  R div_x{};          ///< -sum_j V_j x_ij · grad W_ij: D inside, smaller at a free surface
  Vec<D, R> slope{};  ///< sum_j V_j grad W_ij  [1/m]
  Vec<D, R> wall{};   ///< sum_k V_k grad W_ik over boundary particles  [1/m]
  FRESHET_HD Adami2013Sums& operator+=(const Adami2013Sums& o) {
    push += o.push;
    div_x += o.div_x;
    slope += o.slope;
    wall += o.wall;
    return *this;
  }
};
template <int D, class R>
FRESHET_HD Adami2013Sums<D, R> adami2013_sums(const Vec<D, R>& x_ij, const Vec<D, R>& gradient,
                                              R V_i, R V_j) {
  return {(V_i * V_i + V_j * V_j) * gradient, -V_j * dot(x_ij, gradient), V_j * gradient, {}};
}

/// Adami2013Sums over fluid particles of the volumes V_j = m/rho_j.
///
///   m [kg/m^(3-D)];  reads rho [kg/m^3]
template <int D, template <int> class Kernel> struct Adami2013Background {
  Kernel<D> W;
  Real m;
  Field<Real> rho;
  template <class R> struct At { R volume; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {m / rho[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Adami2013Sums<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                            const At<R>& j) const {
    return adami2013_sums(ij.x, W.gradient(ij), i.volume, j.volume);
  }
};
template <int D, template <int> class K, class... A>
Adami2013Background(K<D>, A...) -> Adami2013Background<D, K>;

/// Adami2013Sums over boundary particles of the volumes V_k = mass_k/rho0. Without memory for
/// `mass` they all have the mass m.
///
///   m, mass [kg/m^(3-D)], rho0 [kg/m^3];  reads rho [kg/m^3]
template <int D, template <int> class Kernel> struct Adami2013WallBackground {
  Kernel<D> W;
  Real m, rho0;
  Field<Real> rho, mass;
  template <class R> struct At { R volume; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {m / rho[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {(mass.data ? mass[k] : m) / rho0}; }
  template <class R>
  FRESHET_HD Adami2013Sums<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                            const At<R>& k) const {
    auto sums = adami2013_sums(ik.x, W.gradient(ik), i.volume, k.volume);
    sums.wall = sums.slope;
    return sums;
  }
};
template <int D, template <int> class K, class... A>
Adami2013WallBackground(K<D>, A...) -> Adami2013WallBackground<D, K>;

/// The effect of the transport velocity on the flow: an acceleration [m/s^2] and a density rate
/// [kg/(m^3 s)].
template <int D, class R> struct Adami2013Rates {
  Vec<D, R> a{};
  R rho{};
  FRESHET_HD Adami2013Rates& operator+=(const Adami2013Rates& o) {
    a += o.a;
    rho += o.rho;
    return *this;
  }
};

/// a    1/m sum_j (V_i^2 + V_j^2) (A_i + A_j)/2 · grad W_ij,  A = rho v (v~ - v)
/// rho  (u_i · grad) rho = sum_j V_j (rho_j - rho_i) (u_i · grad W_ij),  u = v~ - v
///
///   m [kg/m^(3-D)];  reads rho [kg/m^3], v and u [m/s]
///
/// With several liquids, A uses the liquid's own density rho/lightness, and the caller multiplies
/// the sum by the lightness of i.
template <int D, template <int> class Kernel> struct Adami2013Transport {
  Kernel<D> W;
  Real m;
  PerLiquid lightness;
  Field<Real> rho;
  Field<Vec<D>> v, u;
  template <class R> struct At {
    R volume, rho;
    Vec<D, R> half_rho_v, u;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const {
    return {m / rho[i], rho[i], (rho[i] / (2 * lightness[i])) * v[i], u[i]};
  }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Adami2013Rates<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const At<R>& j) const {
    const Vec<D, R> gradient = W.gradient(ij);
    const R along_i = dot(i.u, gradient), along_j = dot(j.u, gradient);
    const R share = (i.volume * i.volume + j.volume * j.volume) / m;
    return {share * (along_i * i.half_rho_v + along_j * j.half_rho_v),
            j.volume * (j.rho - i.rho) * along_i};
  }
};
template <int D, template <int> class K, class... A>
Adami2013Transport(K<D>, A...) -> Adami2013Transport<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

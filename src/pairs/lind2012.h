// SPDX-License-Identifier: MIT
/// Pair terms of particle shifting along the gradient of the particle concentration [Lind, Xu,
/// Stansby, Rogers 2012]. The delta-plus-SPH model uses them as well [Sun, Colagrossi, Marrone,
/// Zhang 2017].
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The gradient of the particle concentration, and the sums that detect the free surface and walls.
template <int D, class R> struct Lind2012Sums {
  Vec<D, R> crowd{};  ///< sum_j V_j (1 + 0.2 (W_ij/W(spacing))^4) grad W_ij  [1/m]
  R div_x{};          ///< -sum_j V_j x_ij · grad W_ij: D inside, smaller at a free surface
  Vec<D, R> slope{};  ///< sum_j V_j grad W_ij  [1/m]
  Vec<D, R> wall{};   ///< sum_k V_k grad W_ik over boundary particles, towards them  [1/m]
  FRESHET_HD Lind2012Sums& operator+=(const Lind2012Sums& o) {
    crowd += o.crowd;
    div_x += o.div_x;
    slope += o.slope;
    wall += o.wall;
    return *this;
  }
};

/// Lind2012Sums over fluid particles of the volumes V_j = m/rho_j.
///
///   m [kg/m^(3-D)];  W_spacing  W at a distance of one spacing [1/m^D];  reads rho [kg/m^3] (> 0)
template <int D, template <int> class Kernel> struct Lind2012Crowd {
  Kernel<D> W;
  Real m, W_spacing;
  Field<Real> rho;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R volume; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {m / rho[j]}; }
  template <class R>
  FRESHET_HD Lind2012Sums<D, R> operator()(const Pair<D, R>& ij, At<R>,
                                           const Neighbor<R>& j) const {
    const Vec<D, R> gradient = j.volume * W.gradient(ij);
    const R near = square(square(W(ij) / W_spacing));
    return {(1 + Real(0.2f) * near) * gradient, -dot(ij.x, gradient), gradient, {}};
  }
};
template <int D, template <int> class K, class... A>
Lind2012Crowd(K<D>, A...) -> Lind2012Crowd<D, K>;

/// Lind2012Sums over boundary particles of the volumes V_k = mass_k/rho0. Without memory for `mass`
/// they all have the mass m.
///
///   m, mass [kg/m^(3-D)], rho0 [kg/m^3];  W_spacing  W at the distance of one spacing [1/m^D]
template <int D, template <int> class Kernel> struct Lind2012WallCrowd {
  Kernel<D> W;
  Real m, rho0, W_spacing;
  Field<Real> mass;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R volume; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {(mass.data ? mass[k] : m) / rho0}; }
  template <class R>
  FRESHET_HD Lind2012Sums<D, R> operator()(const Pair<D, R>& ik, At<R>,
                                           const Neighbor<R>& k) const {
    const Vec<D, R> gradient = k.volume * W.gradient(ik);
    const R near = square(square(W(ik) / W_spacing));
    return {(1 + Real(0.2f) * near) * gradient, -dot(ik.x, gradient), gradient, gradient};
  }
};
template <int D, template <int> class K, class... A>
Lind2012WallCrowd(K<D>, A...) -> Lind2012WallCrowd<D, K>;

/// sum_j W_ij edge_j: a normal of the free surface near it, and zero farther inside.
///
///   reads edge: Lind2012Sums::slope at particles of the free surface, zero elsewhere
template <int D, template <int> class Kernel> struct Lind2012Normal {
  Kernel<D> W;
  Field<Vec<D>> edge;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { Vec<D, R> edge; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {edge[j]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, At<R>, const Neighbor<R>& j) const {
    return W(ij) * j.edge;
  }
};
template <int D, template <int> class K, class... A>
Lind2012Normal(K<D>, A...) -> Lind2012Normal<D, K>;

/// The rates of velocity [m/s^2] and density [kg/(m^3 s)] of a shifted particle.
template <int D, class R> struct ShiftedRates {
  Vec<D, R> v{};
  R rho{};
  FRESHET_HD ShiftedRates& operator+=(const ShiftedRates& o) {
    v += o.v;
    rho += o.rho;
    return *this;
  }
};

/// (u_i · grad) q = sum_j V_j (q_j - q_i) (u_i · grad W_ij) for q the velocity and the density
/// [Lind, Xu, Stansby, Rogers 2012, eq. 33]
///
///   m [kg/m^(3-D)];  reads rho [kg/m^3] (> 0), v and the velocity u of the shift [m/s]
template <int D, template <int> class Kernel> struct ShiftedState {
  Kernel<D> W;
  Real m;
  Field<Real> rho;
  Field<Vec<D>> v, u;
  template <class R> struct At {
    R rho;
    Vec<D, R> v, u;
  };
  template <class R> struct Neighbor {
    R rho;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {rho[i], v[i], u[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {rho[j], v[j]}; }
  template <class R>
  FRESHET_HD ShiftedRates<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                           const Neighbor<R>& j) const {
    const R share = m / j.rho * dot(i.u, W.gradient(ij));
    return {share * (j.v - i.v), share * (j.rho - i.rho)};
  }
};
template <int D, template <int> class K, class... A> ShiftedState(K<D>, A...) -> ShiftedState<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Particle shifting of the delta-plus-SPH model [Sun, Colagrossi, Marrone, Zhang 2017].
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Where a particle's neighbours crowd, and whether they are all there.
template <int D, class R> struct Sun2017Sums {
  Vec<D, R> crowd{};  ///< sum_j V_j (1 + 0.2 (W_ij/W(spacing))^4) grad W_ij  [1/m; eq. 5]
  R div_x{};          ///< -sum_j V_j x_ij · grad W_ij: D inside, less at a surface
  Vec<D, R> wall{};   ///< sum_k V_k grad W_ik over samples of walls, towards them  [1/m]
  FRESHET_HD Sun2017Sums& operator+=(const Sun2017Sums& o) {
    crowd += o.crowd;
    div_x += o.div_x;
    wall += o.wall;
    return *this;
  }
};

/// The sums over particles of the volumes m/rho_j.
///
///   m [kg], W_spacing W at the distance of one spacing [1/m^D];  reads rho
template <int D, template <int> class Kernel> struct Sun2017Crowd {
  Kernel<D> W;
  Real m, W_spacing;
  Field<Real> rho;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R volume; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {m / rho[j]}; }
  template <class R>
  FRESHET_HD Sun2017Sums<D, R> operator()(const Pair<D, R>& ij, At<R>, const Neighbor<R>& j) const {
    const Vec<D, R> gradient = j.volume * W.gradient(ij);
    const R near = square(square(W(ij) / W_spacing));
    return {(1 + Real(0.2f) * near) * gradient, -dot(ij.x, gradient), {}};
  }
};
template <int D, template <int> class K, class... A> Sun2017Crowd(K<D>, A...) -> Sun2017Crowd<D, K>;

/// The same over samples of walls, of the volumes mass_k/rho0; of one mass where `mass` has no
/// memory.
template <int D, template <int> class Kernel> struct Sun2017WallCrowd {
  Kernel<D> W;
  Real m, rho0, W_spacing;
  Field<Real> mass;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R volume; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {(mass.data ? mass[k] : m) / rho0}; }
  template <class R>
  FRESHET_HD Sun2017Sums<D, R> operator()(const Pair<D, R>& ik, At<R>, const Neighbor<R>& k) const {
    const Vec<D, R> gradient = k.volume * W.gradient(ik);
    const R near = square(square(W(ik) / W_spacing));
    return {(1 + Real(0.2f) * near) * gradient, -dot(ik.x, gradient), gradient};
  }
};
template <int D, template <int> class K, class... A>
Sun2017WallCrowd(K<D>, A...) -> Sun2017WallCrowd<D, K>;

/// What is different where a particle is shifted to  [1/s times v, rho].
template <int D, class R> struct ShiftedRates {
  Vec<D, R> v{};
  R rho{};
  FRESHET_HD ShiftedRates& operator+=(const ShiftedRates& o) {
    v += o.v;
    rho += o.rho;
    return *this;
  }
};

/// (u_i · grad) q = sum_j V_j (q_j - q_i) (u_i · grad W_ij) of the velocity and the density
/// [Lind, Xu, Stansby, Rogers 2012, eq. 33]
///
///   m [kg];  reads rho, v and u, the velocity of the shift
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

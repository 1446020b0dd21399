// SPDX-License-Identifier: MIT
/// Pair terms of surface tension by the curvature of surface normals [Morris 2000], for a single
/// phase with a free surface. Every particle has the volume V = m/rho0.
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The gradients of the colour function (1 in the liquid, 0 outside) and of the walls' colour.
template <int D, class R> struct Morris2000Normals {
  Vec<D, R> fluid{};  ///< sum_j V grad W_ij, towards the liquid  [1/m]
  Vec<D, R> wall{};   ///< sum_k V_k grad W_ik, towards the wall  [1/m]
  FRESHET_HD Morris2000Normals& operator+=(const Morris2000Normals& o) {
    fluid += o.fluid;
    wall += o.wall;
    return *this;
  }
};

/// Morris2000Normals::fluid over fluid particles  [eq. 12 without a second phase]
///
///   V = m/rho0 [m^D];  the sum in 1/m
template <int D, template <int> class Kernel> struct Morris2000Normal {
  Kernel<D> W;
  Real V;
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int) const { return {}; }
  template <class R>
  FRESHET_HD Morris2000Normals<D, R> operator()(const Pair<D, R>& ij, At<R>, Neighbor<R>) const {
    return {V * W.gradient(ij), {}};
  }
};
template <int D, template <int> class K, class... A>
Morris2000Normal(K<D>, A...) -> Morris2000Normal<D, K>;

/// Morris2000Normals::wall over boundary particles of the volumes V_k = mass_k/rho0, or V without
/// memory for `mass`.
///
///   V [m^D], rho0 [kg/m^3], mass [kg/m^(3-D)];  the sum in 1/m
template <int D, template <int> class Kernel> struct Morris2000WallNormal {
  Kernel<D> W;
  Real V, rho0;
  Field<Real> mass;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R volume; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {mass.data ? mass[k] / rho0 : V}; }
  template <class R>
  FRESHET_HD Morris2000Normals<D, R> operator()(const Pair<D, R>& ik, At<R>,
                                                const Neighbor<R>& k) const {
    return {{}, k.volume * W.gradient(ik)};
  }
};
template <int D, template <int> class K, class... A>
Morris2000WallNormal(K<D>, A...) -> Morris2000WallNormal<D, K>;

/// sum_j V n_j W_ij: smoothed normals [1/m]  [as eq. 11 smooths the colour]
template <int D, template <int> class Kernel> struct Morris2000Smoothed {
  Kernel<D> W;
  Real V;
  Field<Vec<D>> n;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { Vec<D, R> n; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {n[j]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, At<R>, const Neighbor<R>& j) const {
    return (V * W(ij)) * j.n;
  }
};
template <int D, template <int> class K, class... A>
Morris2000Smoothed(K<D>, A...) -> Morris2000Smoothed<D, K>;

/// The change of unit normals along the surface, and the sum that normalises it.
template <int D, class R> struct Morris2000Turn {
  R turn{};    ///< sum_j V |n_j|^2 (û_j - û_i) · g,  g the tangential part of grad W_ij
  R spread{};  ///< -sum_j V |n_j|^2 x_ij · g
  FRESHET_HD Morris2000Turn& operator+=(const Morris2000Turn& o) {
    turn += o.turn;
    spread += o.spread;
    return *this;
  }
};

/// The sums of the curvature  [eqs. 20 to 24]. Only reliable directions û_j = n_j/|n_j| count,
/// those with |n_j| > least; the weight is |n_j|^2. The curvature is proportional to turn/spread:
/// spread is the value for a linear field, which corrects for the missing neighbours outside.
///
///   n  smoothed normals [1/m];  least [1/m], > 0;  V [m^D]
template <int D, template <int> class Kernel> struct Morris2000Curvature {
  Kernel<D> W;
  Real V, least;
  Field<Vec<D>> n;
  template <class R> struct At { Vec<D, R> n; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {n[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Morris2000Turn<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const Neighbor<R>& j) const {
    const R at_j = norm(j.n), at_i = max(norm(i.n), R(least));
    const Vec<D, R> u = i.n / at_i, gradient = W.gradient(ij);
    const R seen = select(at_j > R(least), V * at_j, R(0));
    const Vec<D, R> along = gradient - dot(gradient, u) * u;
    return {seen * dot(j.n - at_j * u, along), -(seen * at_j) * dot(ij.x, along)};
  }
};
template <int D, template <int> class K, class... A>
Morris2000Curvature(K<D>, A...) -> Morris2000Curvature<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

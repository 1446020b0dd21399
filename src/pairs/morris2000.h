// SPDX-License-Identifier: MIT
/// Surface tension by the curvature of a surface's normals [Morris 2000], of a liquid beside
/// nothing.
///
/// Every particle counts as the volume m/rho0, so that V = m/rho0 is one number.
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The gradient of the colour, which is 1 in the liquid and 0 outside, and that of the walls'.
template <int D, class R> struct Morris2000Normals {
  Vec<D, R> fluid{};  ///< sum_j V grad W_ij, towards the liquid  [1/m]
  Vec<D, R> wall{};   ///< sum_k V_k grad W_ik, towards the wall  [1/m]
  FRESHET_HD Morris2000Normals& operator+=(const Morris2000Normals& o) {
    fluid += o.fluid;
    wall += o.wall;
    return *this;
  }
};

/// The sum over particles of the fluid  [eq. 12, nothing being outside]
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

/// The sum over samples of walls, of the volumes mass_k/rho0, or V where `mass` has no memory.
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

/// sum_j V n_j W_ij: the same, smoother  [as eq. 11 does with the colour]
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

/// How unit normals turn along the surface, and how much of the surface there is to see.
template <int D, class R> struct Morris2000Turn {
  R turn{};    ///< sum_j V |n_j|^2 (û_j - û_i) · g,  g what of grad W_ij is along the surface
  R spread{};  ///< -sum_j V |n_j|^2 x_ij · g
  FRESHET_HD Morris2000Turn& operator+=(const Morris2000Turn& o) {
    turn += o.turn;
    spread += o.spread;
    return *this;
  }
};

/// The sums of the curvature  [eqs. 20 to 24]: of directions û_j = n_j/|n_j| that can be relied on,
/// |n_j| >= least, the more the longer n_j is; corrected by what a linear field would give along
/// the surface, where half of the neighbours are missing across it.
///
///   n the smoothed normals;  least [1/m], above 0
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

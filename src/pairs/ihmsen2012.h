// SPDX-License-Identifier: MIT
/// Pair terms of unified spray, foam and air bubbles for particle-based fluids [Ihmsen, Akinci,
/// Akinci, Teschner 2012]. The potentials are means over neighbours, not sums, as in Bender,
/// Koschier, Kugelstadt, Weiler 2019: their limits then depend on neither spacing nor support.
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// sum_j grad W_ij: V times the sum is the gradient of the colour field [1/m].
template <int D, template <int> class Kernel> struct Ihmsen2012Gradient {
  Kernel<D> W;
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int) const { return {}; }
  template <class R> FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, At<R>, At<R>) const {
    return W.gradient(ij);
  }
};
template <int D, template <int> class K> Ihmsen2012Gradient(K<D>) -> Ihmsen2012Gradient<D, K>;

/// Sums over the neighbours other than i: their weights w, their number, and the two potentials.
template <int D, class R> struct Ihmsen2012Sums {
  R weight{}, neighbors{}, trapped_air{}, wave_crest{};
  FRESHET_HD Ihmsen2012Sums& operator+=(const Ihmsen2012Sums& o) {
    weight += o.weight;
    neighbors += o.neighbors;
    trapped_air += o.trapped_air;
    wave_crest += o.wave_crest;
    return *this;
  }
};

/// trapped air  sum_j |v_ij| (1 - v^_ij · x^_ij) w_ij                       [eq. 2; m/s]
/// wave crest   sum_j (1 - n_i · n_j) w_ij over the j below the plane at i  [eq. 4]
/// w = 1 - r/h                                                              [eq. 3]
///
///   h  support radius [m];  reads v [m/s] and n, the outward normal of a surface particle, else 0
template <int D> struct Ihmsen2012Potentials {
  Real h;
  Field<Vec<D>> v, n;
  template <class R> struct At { Vec<D, R> v, n; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {v[i], n[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Ihmsen2012Sums<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const At<R>& j) const {
    const R near = select(ij.r < R(h), R(1), R(0)), other = select(ij.r > R(0), near, R(0));
    const R w = other * (R(1) - ij.r / R(h));
    const Vec<D, R> v = i.v - j.v;
    const R approach = sqrt(norm2(v)) - dot(v, ij.x) / max(ij.r, R(Real(1e-20f)));
    const R turned = dot(j.n, j.n) - dot(i.n, j.n);
    return {w, other, w * approach, w * select(dot(ij.x, i.n) > R(0), turned, R(0))};
  }
};

/// Sums over the fluid around a whitewater particle: W [1/m^D], W v, and the number of neighbours.
template <int D, class R> struct Ihmsen2012Flow {
  R weight{}, neighbors{};
  Vec<D, R> v{};
  FRESHET_HD Ihmsen2012Flow& operator+=(const Ihmsen2012Flow& o) {
    weight += o.weight;
    neighbors += o.neighbors;
    v += o.v;
    return *this;
  }
};

/// The numerator and the denominator of the fluid's mean velocity [eq. 11]. Reads v [m/s].
template <int D, template <int> class Kernel> struct Ihmsen2012FlowAround {
  Kernel<D> W;
  Real h;
  Field<Vec<D>> v;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { Vec<D, R> v; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {v[j]}; }
  template <class R>
  FRESHET_HD Ihmsen2012Flow<D, R> operator()(const Pair<D, R>& ij, At<R>,
                                             const Neighbor<R>& j) const {
    const R weight = W(ij);
    return {weight, select(ij.r < R(h), R(1), R(0)), weight * j.v};
  }
};
template <int D, template <int> class K, class... A>
Ihmsen2012FlowAround(K<D>, A...) -> Ihmsen2012FlowAround<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

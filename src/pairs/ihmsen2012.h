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

/// Sums over the neighbours other than i: their weights w, and w times a potential.
template <int D, class R> struct Ihmsen2012Mean {
  R weight{}, potential{};
  FRESHET_HD Ihmsen2012Mean& operator+=(const Ihmsen2012Mean& o) {
    weight += o.weight;
    potential += o.potential;
    return *this;
  }
  FRESHET_HD R mean() const { return weight > 0 ? potential / weight : R(0); }
};
/// The same, and the number of neighbours.
template <int D, class R> struct Ihmsen2012Sums {
  R weight{}, potential{}, neighbors{};
  FRESHET_HD Ihmsen2012Sums& operator+=(const Ihmsen2012Sums& o) {
    weight += o.weight;
    potential += o.potential;
    neighbors += o.neighbors;
    return *this;
  }
  FRESHET_HD R mean() const { return weight > 0 ? potential / weight : R(0); }
};

/// w = 1 - r/h  [eq. 3]: 0 for the particle itself and beyond the support radius h [m].
template <class P, class R = decltype(P::r)> FRESHET_HD R ihmsen2012_weight(const P& ij, Real h) {
  return select(ij.r > R(0), max(R(1) - ij.r / R(h), R(0)), R(0));
}

/// Trapped air  sum_j |v_ij| (1 - v^_ij · x^_ij) w_ij  [eq. 2; m/s]. Reads v [m/s].
template <int D> struct Ihmsen2012TrappedAir {
  Real h;
  Field<Vec<D>> v;
  template <class R> struct At { Vec<D, R> v; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Ihmsen2012Sums<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const At<R>& j) const {
    const R w = ihmsen2012_weight(ij, h);
    const Vec<D, R> v = i.v - j.v;
    const R approach = sqrt(norm2(v)) - dot(v, ij.x) / max(ij.r, R(Real(1e-20f)));
    return {w, w * approach, select(w > R(0), R(1), R(0))};
  }
};

/// Wave crest  sum_j (1 - n_i · n_j) w_ij over the j below the plane at i  [eq. 4]. Reads n, the
/// outward normal of a surface particle, else 0.
template <int D> struct Ihmsen2012WaveCrest {
  Real h;
  Field<Vec<D>> n;
  template <class R> struct At { Vec<D, R> n; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {n[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Ihmsen2012Mean<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const At<R>& j) const {
    const R w = ihmsen2012_weight(ij, h);
    const R turned = dot(j.n, j.n) - dot(i.n, j.n);
    return {w, w * select(dot(ij.x, i.n) > R(0), turned, R(0))};
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

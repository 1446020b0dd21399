// SPDX-License-Identifier: MIT
/// A micropolar material model for turbulent SPH fluids [Bender, Koschier, Kugelstadt, Weiler
/// 2017]: particles spin, and give their spin back to the flow.
#pragma once
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// a x b of a plane's vectors: a number, the part across the plane; and a x (0, 0, b).
template <class R> FRESHET_HD R curl_of(Vec<2, R> a, Vec<2, R> b) { return a.x * b.y - a.y * b.x; }
template <class R> FRESHET_HD Vec<3, R> curl_of(Vec<3, R> a, Vec<3, R> b) { return cross(a, b); }
template <class R> FRESHET_HD Vec<2, R> curl_of(Vec<2, R> a, R b) {
  return {a.y * b, Real(-1) * (a.x * b)};
}

/// An angular velocity: a number in 2D.
template <int D, class R> struct SpinOf { using type = Vec<3, R>; };
template <class R> struct SpinOf<2, R> { using type = R; };
template <int D, class R> using Spin = typename SpinOf<D, R>::type;

/// curl v_i = 1/rho_i sum_j m grad W_ij x (v_j - v_i)  [eq. 12]: of a rotation exact on a lattice.
///
///   reads v; the sum over m/rho_i is the curl [1/s]
template <int D, template <int> class Kernel> struct Bender2017CurlV {
  Kernel<D> W;
  Field<Vec<D>> v;
  template <class R> struct At { Vec<D, R> v; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Spin<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    return curl_of(W.gradient(ij), j.v - i.v);
  }
};
template <int D, template <int> class K, class... A>
Bender2017CurlV(K<D>, A...) -> Bender2017CurlV<D, K>;

/// curl omega_i = rho_i sum_j m grad W_ij x (omega_i/rho_i^2 + omega_j/rho_j^2): what i gives j, j
/// gives back, so that momentum is conserved, as the paper's difference would not.
///
///   reads w = omega/rho^2; the sum times m rho_i nu_t is an acceleration [m/s^2]
template <int D, template <int> class Kernel> struct Bender2017CurlSpin {
  Kernel<D> W;
  Field<Spin<D, Real>> spin;
  Field<Real> rho;
  template <class R> struct At { Spin<D, R> w; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {(1 / square(rho[i])) * spin[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    return curl_of(W.gradient(ij), i.w + j.w);
  }
};
template <int D, template <int> class K, class... A>
Bender2017CurlSpin(K<D>, A...) -> Bender2017CurlSpin<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

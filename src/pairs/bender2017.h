// SPDX-License-Identifier: MIT
/// Pair terms of a micropolar material model for turbulent SPH fluids [Bender, Koschier,
/// Kugelstadt, Weiler 2017]. Each particle has an angular velocity that exchanges momentum with the
/// flow.
#pragma once
#include "pairs/per_liquid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The cross product a x b. In 2D that of two vectors is its z component; that of a vector and a
/// number b is a x (0, 0, b).
template <class R> FRESHET_HD R curl_of(Vec<2, R> a, Vec<2, R> b) { return a.x * b.y - a.y * b.x; }
template <class R> FRESHET_HD Vec<3, R> curl_of(Vec<3, R> a, Vec<3, R> b) { return cross(a, b); }
template <class R> FRESHET_HD Vec<2, R> curl_of(Vec<2, R> a, R b) {
  return {a.y * b, Real(-1) * (a.x * b)};
}

/// The type of an angular velocity: a number in 2D, a vector in 3D.
template <int D, class R> struct SpinOf { using type = Vec<3, R>; };
template <class R> struct SpinOf<2, R> { using type = R; };
template <int D, class R> using Spin = typename SpinOf<D, R>::type;

/// sum_j grad W_ij x (v_j - v_i), of which curl v_i is m/rho_i times the sum  [eq. 12].
///
///   reads v [m/s];  the curl in 1/s
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

/// sum_j grad W_ij x (omega_i/rho_i^2 + omega_j/rho_j^2), of which curl omega_i is m rho_i times
/// the sum. The symmetric form conserves momentum; the paper's difference form does not.
///
///   reads omega [1/s] and rho [kg/m^3] (> 0);  the sum times m rho_i nu_t in m/s^2
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

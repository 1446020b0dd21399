// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// rho*_i = sum_j m W(x*_i - x*_j),  x* = x + moved  [Solenthaler and Pajarola 2009, algorithm 2]
///
///   m  mass over the kernel's lattice sum [kg/m^(3-D)];  moved [m];  the sum in kg/m^3
///
/// The neighbours are those of x, not of x*.
template <int D, template <int> class Kernel> struct PredictedDensity {
  Kernel<D> W;
  Real m;
  Field<Vec<D>> moved;
  template <class R> struct At { Vec<D, R> moved; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {moved[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    return m * W(Pair<D, R>(ij.x + (i.moved - j.moved)));
  }
};
template <int D, template <int> class K, class... A>
PredictedDensity(K<D>, A...) -> PredictedDensity<D, K>;

/// rho*_i += sum_k psi_k W(x*_i - x*_k),  x*_k = x_k + dt v_k  [Akinci 2012, eq. 6]
///
///   psi [kg/m^(3-D)], moved [m], dt [s], v_wall [m/s];  the sum in kg/m^3
template <int D, template <int> class Kernel> struct Akinci2012PredictedDensity {
  Kernel<D> W;
  Field<Real> psi;
  Field<Vec<D>> moved;
  Real dt;
  Field<Vec<D>> v_wall;
  template <class R> struct At { Vec<D, R> moved; };
  template <class R> struct Neighbor {
    R psi;
    Vec<D, R> moved;
  };
  FRESHET_HD At<Real> at(int i) const { return {moved[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k], dt * v_wall[k]}; }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ik, const At<R>& i, const Neighbor<R>& k) const {
    return k.psi * W(Pair<D, R>(ik.x + (i.moved - k.moved)));
  }
};
template <int D, template <int> class K, class... A>
Akinci2012PredictedDensity(K<D>, A...) -> Akinci2012PredictedDensity<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

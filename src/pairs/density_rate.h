// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Drho_i/Dt = sum_j m (v_i - v_j) · grad W_ij  [Bender and Koschier 2017, eq. 10]
///
///   m [kg/m^(3-D)], v [m/s];  the sum in kg/(m^3 s)
///
/// With accelerations in place of v it is the rate of Drho_i/Dt [kg/(m^3 s^2)].
template <int D, template <int> class Kernel> struct DensityRate {
  Kernel<D> W;
  Real m;
  Field<Vec<D>> v;
  template <class R> struct At { Vec<D, R> v; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    return m * dot(i.v - j.v, W.gradient(ij));
  }
};
template <int D, template <int> class K, class... A> DensityRate(K<D>, A...) -> DensityRate<D, K>;

/// Drho_i/Dt += sum_k psi_k v_i · grad W_ik  over boundary particles at rest  [Akinci 2012]
///
///   psi [kg/m^(3-D)], v [m/s];  the sum in kg/(m^3 s)
template <int D, template <int> class Kernel> struct Akinci2012DensityRate {
  Kernel<D> W;
  Field<Real> psi;
  Field<Vec<D>> v;
  template <class R> struct At { Vec<D, R> v; };
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int i) const { return {v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k]}; }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ik, const At<R>& i, const Neighbor<R>& k) const {
    return k.psi * dot(i.v, W.gradient(ik));
  }
};
template <int D, template <int> class K, class... A>
Akinci2012DensityRate(K<D>, A...) -> Akinci2012DensityRate<D, K>;

/// sum_k psi_k v_k · grad W_ik: the density rate by moving boundary particles, which is subtracted
/// from Akinci2012DensityRate. It is a separate pass, so that scenes without moving walls do not
/// pay for it.
///
///   psi [kg/m^(3-D)], v_wall [m/s];  the sum in kg/(m^3 s)
template <int D, template <int> class Kernel> struct MovingDensityRate {
  Kernel<D> W;
  Field<Real> psi;
  Field<Vec<D>> v_wall;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { Vec<D, R> psi_v; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k] * v_wall[k]}; }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ik, At<R>, const Neighbor<R>& k) const {
    return dot(k.psi_v, W.gradient(ik));
  }
};
template <int D, template <int> class K, class... A>
MovingDensityRate(K<D>, A...) -> MovingDensityRate<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

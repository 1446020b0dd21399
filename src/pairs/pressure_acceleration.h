// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// a_i = -sum_j m (k_i + k_j) grad W_ij,  k = p/rho^2
/// [Solenthaler and Pajarola 2009, eq. 6; Ihmsen 2014, eq. 2; Bender and Koschier 2017, eq. 6]
///
/// The sum is the transpose of DensityRate, so the density rate as a function of k is symmetric.
///
///   m [kg/m^(3-D)], k [Pa m^6/kg^2];  the sum in m/s^2
template <int D, template <int> class Kernel> struct PressureAcceleration {
  Kernel<D> W;
  Real m;
  Field<Real> k;
  template <class R> struct At { R k; };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {k[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    return (-m * (i.k + j.k)) * W.gradient(ij);
  }
};
template <int D, template <int> class K, class... A>
PressureAcceleration(K<D>, A...) -> PressureAcceleration<D, K>;

/// a_i += -sum_s psi_s k_i grad W_is over boundary particles s, which mirror the pressure of i
/// [Akinci 2012]
///
///   psi [kg/m^(3-D)], k [Pa m^6/kg^2];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Akinci2012PressureAcceleration {
  Kernel<D> W;
  Field<Real> k, psi;
  template <class R> struct At { R k; };
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int i) const { return {k[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int s) const { return {psi[s]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& is, const At<R>& i,
                                  const Neighbor<R>& s) const {
    return (-i.k * s.psi) * W.gradient(is);
  }
};
template <int D, template <int> class K, class... A>
Akinci2012PressureAcceleration(K<D>, A...) -> Akinci2012PressureAcceleration<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

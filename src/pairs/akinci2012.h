// SPDX-License-Identifier: MIT
/// Pair terms of walls with one layer of boundary particles. Each has the volume that its
/// neighbours leave it: versatile rigid-fluid coupling [Akinci, Ihmsen, Akinci, Solenthaler,
/// Teschner 2012].
#pragma once
#include "core/field.h"
#include "pairs/becker2007_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// sum_l W_kl over the boundary particles l of the wall [1/m^D], from which the caller gets
/// psi_k = rho0 V_k = rho0/sum_l W_kl [eqs. 4 and 5].
template <int D, template <int> class Kernel> struct Akinci2012Volume {
  Kernel<D> W;
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int) const { return {}; }
  template <class R> FRESHET_HD R operator()(const Pair<D, R>& kl, At<R>, At<R>) const {
    return W(kl);
  }
};
template <int D, template <int> class K> Akinci2012Volume(K<D>) -> Akinci2012Volume<D, K>;

/// rho_i += sum_k psi_k W_ik  [eq. 6]
///
///   psi [kg/m^(3-D)];  the sum in kg/m^3
template <int D, template <int> class Kernel> struct Akinci2012Density {
  Kernel<D> W;
  Field<Real> psi;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k]}; }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& ik, At<R>, const Neighbor<R>& k) const {
    return k.psi * W(ik);
  }
};
template <int D, template <int> class K, class... A>
Akinci2012Density(K<D>, A...) -> Akinci2012Density<D, K>;

/// dv_i/dt += -sum_k psi_k (p_i/rho_i^2 + friction_k Pi_ik) grad W_ik  [eqs. 9, 11 and 13]
///
/// The wall mirrors the pressure of the particle and moves with v_k.
///
///   psi [kg/m^(3-D)], friction 1 for no slip, 0 for free slip
///   reads p [Pa], rho [kg/m^3] (> 0), v, v_wall [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Akinci2012Forces {
  Kernel<D> W;
  ArtificialViscosity Pi;
  Field<Real> p, rho;
  Field<Vec<D>> v;
  Field<Real> psi, friction;
  Field<Vec<D>> v_wall;
  template <class R> struct At {
    R p_rho2, rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R psi, friction;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {p[i] / square(rho[i]), rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k], friction[k], v_wall[k]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R Pi_ik = k.friction * Pi(ik, i.v - k.v, i.rho, i.rho);
    return (-k.psi * (i.p_rho2 + Pi_ik)) * W.gradient(ik);
  }
};
template <int D, template <int> class K, class... A>
Akinci2012Forces(K<D>, A...) -> Akinci2012Forces<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Pair terms of walls with several layers of boundary particles, whose pressure and velocity are
/// extrapolated from the fluid: a generalized wall boundary condition for SPH [Adami, Hu, Adams
/// 2012].
#pragma once
#include "core/fluid_particles.h"
#include "pairs/becker2007_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The sums over fluid particles f from which a wall particle w extrapolates.
template <int D, class R> struct Adami2012Sums {
  R W{}, p{}, rho_x{};  ///< sum_f W, p_f W, rho_f x_wf · (g - a_w) W
  Vec<D, R> v{};        ///< sum_f v_f W
  FRESHET_HD Adami2012Sums& operator+=(const Adami2012Sums& o) {
    W += o.W;
    p += o.p;
    rho_x += o.rho_x;
    v += o.v;
    return *this;
  }
};

/// p_w = (sum_f p_f W_wf + (g - a_w) · sum_f rho_f x_wf W_wf)/sum_f W_wf  [eq. 27]
/// v_w = 2 u_w - sum_f v_f W_wf/sum_f W_wf                 [eqs. 22 and 23: no slip]
///
///   u_w, a_w   velocity and acceleration of the wall at w [m/s, m/s^2]
///   reads p [Pa], rho [kg/m^3] and v [m/s] of the fluid; yields Adami2012Sums
template <int D, template <int> class Kernel> struct Adami2012Extrapolation {
  Kernel<D> W;
  Vec<D> gravity;
  Liquids liquids;
  FluidParticles<D> fluid;
  Field<Vec<D>> a_wall;
  template <class R> struct At { Vec<D, R> g; };
  template <class R> struct Neighbor {
    R p, rho;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int w) const { return {gravity - a_wall[w]}; }
  FRESHET_HD Neighbor<Real> neighbor(int f) const {
    return {fluid.p[f], fluid.rho[f] / liquids.lightness(fluid, f), fluid.v[f]};
  }
  template <class R>
  FRESHET_HD Adami2012Sums<D, R> operator()(const Pair<D, R>& wf, const At<R>& w,
                                            const Neighbor<R>& f) const {
    const R W_wf = W(wf);
    return {W_wf, f.p * W_wf, f.rho * dot(wf.x, w.g) * W_wf, W_wf * f.v};
  }
};
template <int D, template <int> class K, class... A>
Adami2012Extrapolation(K<D>, A...) -> Adami2012Extrapolation<D, K>;

/// sum_w V u_w · grad W_iw: the density rate of moving walls, over rho_i. It is subtracted from the
/// rate for walls at rest, rho_i sum_w V v_i · grad W_iw. It is a separate pass, so that scenes
/// without moving walls do not pay for it.
///
///   V [m^D], u_w [m/s];  the sum in 1/s
template <int D, template <int> class Kernel> struct Adami2012MovingRate {
  Kernel<D> W;
  Real V;
  Field<Vec<D>> u_wall;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { Vec<D, R> V_u; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int w) const { return {V * u_wall[w]}; }
  template <class R>
  FRESHET_HD R operator()(const Pair<D, R>& iw, At<R>, const Neighbor<R>& w) const {
    return dot(w.V_u, W.gradient(iw));
  }
};
template <int D, template <int> class K, class... A>
Adami2012MovingRate(K<D>, A...) -> Adami2012MovingRate<D, K>;

/// dv_i/dt += -sum_w m (p_i/rho_i^2 + p_w/rho0^2 + friction_w Pi_iw) grad W_iw
///
/// Forces of wall particles that have the fluid's mass [Becker and Teschner 2007, eqs. 6 and 10].
///
///   m [kg/m^(3-D)], rho0 [kg/m^3], friction 1 for no slip, 0 for free slip
///   reads p, p_wall [Pa], rho [kg/m^3] (> 0), v, v_wall [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Adami2012Forces {
  Kernel<D> W;
  ArtificialViscosity Pi;
  Real m, rho0;
  Field<Real> p, rho;
  Field<Vec<D>> v;
  Field<Real> p_wall, friction;
  Field<Vec<D>> v_wall;
  template <class R> struct At {
    R p_rho2, rho;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R p_rho2, friction;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {p[i] / square(rho[i]), rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int w) const {
    return {p_wall[w] / square(rho0), friction[w], v_wall[w]};
  }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& iw, const At<R>& i,
                                  const Neighbor<R>& w) const {
    const R Pi_iw = w.friction * Pi(iw, i.v - w.v, i.rho, R(rho0));
    return (-m * (i.p_rho2 + w.p_rho2 + Pi_iw)) * W.gradient(iw);
  }
};
template <int D, template <int> class K, class... A>
Adami2012Forces(K<D>, A...) -> Adami2012Forces<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet

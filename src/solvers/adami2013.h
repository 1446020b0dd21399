// SPDX-License-Identifier: MIT
#pragma once
#include "pairs/adami2013.h"
#include "solvers/shifting.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The transport velocity [Adami, Hu, Adams 2013]. Particles move with
///
///   v~_i = v_i - dt/2 p_b/m sum_j (V_i^2 + V_j^2) grad W_ij,  p_b = rho0 c0^2
///
/// They carry momentum, by which the flow is accelerated:
///
///   1/m sum_j (V_i^2 + V_j^2) (A_i + A_j)/2 · grad W_ij,  A = rho v (v~ - v)
///
/// Particles with boundary particles in their support are not shifted: the uniform pressure would
/// push them through the walls. The paper computes densities by summation. Where the density is
/// kept, it changes by (v~ - v) · grad rho. Without sound, c0 = h/(4 dt) with h half the support,
/// the largest step of the paper.
///
///   m [kg], rho0 [kg/m^D], h [m], c0 [m/s]
template <int D, class B, template <int> class Kernel> struct Adami2013 final : Shifting<D, B> {
  using typename Shifting<D, B>::Fluid;
  Kernel<D> W;
  Real m, rho0, h, c0;  ///< c0 = 0 for a solver without sound
  ShiftingAtSurface<D, B, Kernel> surface;
  Field<Vec<D>> u;   ///< scratch: v~ - v [m/s]
  Field<Real> drho;  ///< scratch: density rate by v~ - v [kg/(m^D s)]
  Adami2013(Kernel<D> W, Real m, Real rho0, Real h, Real c0)
      : W(W), m(m), rho0(rho0), h(h), c0(c0), surface{W, {}} {}

  void fields(FieldMaker<D>& maker) override {
    maker.make("shift", Keep::scratch, u);
    maker.make("shift_drho", Keep::scratch, drho);
    surface.fields(maker);
  }
  void find(B& backend, const Fluid& f, const Walls<D>& w, Real dt, PerLiquid lightness,
            Field<Vec<D>> push) override {
    find_transport(backend, f, w, dt);
    surface.keep_along(backend, f, u);
    backend.share("shift", f, u);
    find_change(backend, f, lightness, push);
  }
  void move(B& backend, const Fluid& fluid, Real dt) const override {
    const auto f = fluid;
    const auto u = this->u;
    const auto drho = this->drho;
    backend.for_each("shift", f, [=] FRESHET_LAMBDA(int i) {
      f.x[i] += dt * u[i];
      f.rho[i] += dt * drho[i];
    });
  }

  // Public for nvcc, which takes no lambdas from private functions.
  void find_transport(B& backend, const Fluid& f, const Walls<D>& w, Real dt) const {
    const auto u = this->u, edge = surface.edge;
    const Real c = c0 > 0 ? c0 : dt > 0 ? h / (4 * dt) : 0;
    const Real factor = -dt / 2 * c * c * rho0 / m, inside = this->inside;
    backend.sum_pairs(
        "shift", f, over(f, Adami2013Background{W, m, f.rho}),
        over(w.akinci2012, Adami2013WallBackground{W, m, rho0, f.rho, w.akinci2012.psi}),
        over(w.adami2012, Adami2013WallBackground{W, m, rho0, f.rho, Field<Real>{}}),
        [=] FRESHET_LAMBDA(int i, const Adami2013Sums<D, Real>& sum) {
          u[i] = norm2(sum.wall) > 0 ? Vec<D>{} : factor * sum.push;
          edge[i] = sum.div_x < inside ? sum.slope : Vec<D>{};
        });
  }
  void find_change(B& backend, const Fluid& f, PerLiquid lightness, Field<Vec<D>> push) const {
    const auto drho = this->drho;
    backend.sum_pairs("shift", f, over(f, Adami2013Transport{W, m, lightness, f.rho, f.v, u}),
                      [=] FRESHET_LAMBDA(int i, const Adami2013Rates<D, Real>& sum) {
                        push[i] += lightness[i] * sum.a;
                        drho[i] = sum.rho;
                      });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

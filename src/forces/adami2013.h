// SPDX-License-Identifier: MIT
#pragma once
#include "forces/shifting.h"
#include "pairs/adami2013.h"

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
/// What sees a wall moves with the flow: pressed by one, particles leave a cavity through its walls
/// at last. The paper sums densities; where the density is kept, it is that of the flow where the
/// particle has come to. Where there is no sound, the step is the paper's longest: c0 = h/(4 dt), h
/// half the support.
template <int D, class B, template <int> class Kernel> struct Adami2013 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  Kernel<D> W;
  Real m, rho0, h, c0;  ///< c0 = 0 for a solver without sound
  ShiftingAtSurface<D, B, Kernel> surface;
  Field<Vec<D>> u;   ///< scratch: v~ - v [m/s]
  Field<Real> drho;  ///< scratch: rate of the density by it [kg/(m^3 s)]
  Liquids liquids;
  Adami2013(const ForceParameters<D>& c, Kernel<D> W)
      : W(W), m(c.m), rho0(c.rho0), h(c.h), c0(c.c0), surface{W, {}}, liquids(c.liquids) {}
  static bool acts(const ForceParameters<D>& c) { return c.shifting == ShiftingMethod::adami2013; }

  void fields(FieldMaker<D>& maker) override {
    maker.make("shift", Keep::scratch, u);
    maker.make("shift_drho", Keep::scratch, drho);
    surface.fields(maker);
  }
  void add(B& backend, const Fluid& f, const Walls<D>& w, Real dt, Field<Vec<D>> push) override {
    find_transport(backend, f, w, dt);
    surface.keep_along(backend, f, u);
    backend.share("shift", f, u);
    find_change(backend, f, liquids.each(&Liquid::lightness, f), push);
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
    const Real factor = -dt / 2 * c * c * rho0 / m, inside = inside_from<D>;
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

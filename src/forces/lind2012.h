// SPDX-License-Identifier: MIT
#pragma once
#include "forces/shifting.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particle shifting [Lind, Xu, Stansby, Rogers 2012]. After a step a particle is shifted by
///
///   dr_i = -h^2/2 crowd_i,  |dr_i| <= min(0.2 h, U dt/2),  U = max |v|
///
/// from where its neighbours crowd, however short the step is; h is half the support. The paper's
/// bound is 0.2 h, in steps that the flow rules (0.4 h/U); where sound does, the other is the same
/// speed. What sees a wall stays: the flow would press it back, and along it particles would gain
/// energy by shifts as large as these.
template <int D, class B, template <int> class Kernel> struct Lind2012 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  ConcentrationShifting<D, B, Kernel> shift;
  ShiftingAtSurface<D, B, Kernel> surface;
  Real h;
  Lind2012(const ForceParameters<D>& c, Kernel<D> W)
      : shift{W, c.m, c.rho0, c.W_spacing, {}, {}, {}}, surface{W, {}}, h(c.h) {}
  static bool acts(const ForceParameters<D>& c) { return c.shifting == ShiftingMethod::lind2012; }

  void fields(FieldMaker<D>& maker) override {
    shift.fields(maker);
    surface.fields(maker);
  }
  void add(B& backend, const Fluid& f, const Walls<D>& w, Real dt, Field<Vec<D>>) override {
    const auto u = shift.u, edge = surface.edge;
    const Real U = shift.fastest(backend, f), per_dt = dt > 0 ? 1 / dt : 0;
    const Real factor = -square(h) / 2 * per_dt, most = min(Real(0.2f) * h * per_dt, U / 2);
    const Real inside = inside_from<D>;
    shift.sum_crowd(backend, f, w, [=] FRESHET_LAMBDA(int i, const Lind2012Sums<D, Real>& sum) {
      const Vec<D> at = factor * sum.crowd;
      const Real fast = norm(at);
      u[i] = norm2(sum.wall) > 0 ? Vec<D>{} : fast > most ? (most / fast) * at : at;
      edge[i] = sum.div_x < inside ? sum.slope : Vec<D>{};
    });
    surface.keep_along(backend, f, u);
    shift.find_change(backend, f);
  }
  void move(B& backend, const Fluid& f, Real dt) const override { shift.move(backend, f, dt); }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

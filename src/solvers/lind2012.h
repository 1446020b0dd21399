// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/shifting.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particle shifting [Lind, Xu, Stansby, Rogers 2012]. After a step a particle is shifted by
///
///   dr_i = -h^2/2 crowd_i,  |dr_i| <= min(0.2 h, U dt/2),  U = max |v|
///
/// along the gradient of the concentration, whatever the length of the step; h is half the support.
/// The paper's bound is 0.2 h, for steps limited by the flow (0.4 h/U). The bound U dt/2 is the
/// same speed for the shorter steps that sound limits. Particles with boundary particles in their
/// support are not shifted: the flow would push them back, and shifts along the wall would add
/// energy.
///
///   m [kg], rho0 [kg/m^D], h [m];  W_spacing  W at the distance of one spacing [1/m^D]
template <int D, class B, template <int> class Kernel> struct Lind2012 final : Shifting<D, B> {
  using typename Shifting<D, B>::Fluid;
  ConcentrationShifting<D, B, Kernel> shift;
  ShiftingAtSurface<D, B, Kernel> surface;
  Real h;
  Lind2012(Kernel<D> W, Real m, Real rho0, Real h, Real W_spacing)
      : shift{W, m, rho0, W_spacing, {}, {}, {}}, surface{W, {}}, h(h) {}

  void fields(FieldMaker<D>& maker) override {
    shift.fields(maker);
    surface.fields(maker);
  }
  void find(B& backend, const Fluid& f, const Walls<D>& w, Real dt, PerLiquid,
            Field<Vec<D>>) override {
    const auto u = shift.u, edge = surface.edge;
    const Real U = shift.fastest(backend, f), per_dt = dt > 0 ? 1 / dt : 0;
    const Real factor = -square(h) / 2 * per_dt, most = min(Real(0.2f) * h * per_dt, U / 2);
    const Real inside = this->inside;
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

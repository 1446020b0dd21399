// SPDX-License-Identifier: MIT
#pragma once
#include "forces/shifting.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particle shifting [Sun, Colagrossi, Marrone, Zhang 2017]. After a step a particle is shifted
/// with the velocity
///
///   u_i = -2 U h crowd_i,  |u_i| <= U/2,  U = max |v|                           [eq. 5, h = H/2]
///
/// from where its neighbours crowd: the paper's CFL Ma is U dt/h. Particles of a free surface,
/// which see less than 0.75 D of their neighbours, stay; what sees a wall is moved along it only:
/// the flow would press it back, and the density would rise without end.
template <int D, class B, template <int> class Kernel> struct Sun2017 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  ConcentrationShifting<D, B, Kernel> shift;
  Real h;
  Sun2017(const ForceParameters<D>& c, Kernel<D> W)
      : shift{W, c.m, c.rho0, c.W_spacing, {}, {}, {}}, h(c.h) {}
  static bool acts(const ForceParameters<D>& c) { return c.shifting == ShiftingMethod::sun2017; }

  void fields(FieldMaker<D>& maker) override { shift.fields(maker); }
  void add(B& backend, const Fluid& f, const Walls<D>& w, Real, Field<Vec<D>>) override {
    const auto u = shift.u;
    const Real U = shift.fastest(backend, f);
    const Real factor = -2 * U * h, most = U / 2, inside = inside_from<D>;
    shift.sum_crowd(backend, f, w, [=] FRESHET_LAMBDA(int i, const Lind2012Sums<D, Real>& sum) {
      const Real wall2 = norm2(sum.wall);
      const Vec<D> across = wall2 > 0 ? dot(sum.crowd, sum.wall) / wall2 * sum.wall : Vec<D>{};
      const Vec<D> at = factor * (sum.crowd - across);
      const Real fast = norm(at);
      u[i] = sum.div_x < inside ? Vec<D>{} : fast > most ? (most / fast) * at : at;
    });
    shift.find_change(backend, f);
  }
  void move(B& backend, const Fluid& f, Real dt) const override { shift.move(backend, f, dt); }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

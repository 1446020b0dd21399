// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/shifting.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particle shifting [Sun, Colagrossi, Marrone, Zhang 2017]. After a step a particle is shifted
/// with the velocity
///
///   u_i = -2 U h crowd_i,  |u_i| <= U/2,  U = max |v|                           [eq. 5, h = H/2]
///
/// along the gradient of the concentration; the paper's CFL Ma is U dt/h. Particles of a free
/// surface, where -sum_j V_j x_ij · grad W_ij < 0.75 D, are not shifted. Particles with boundary
/// particles in their support are shifted along the wall only: the flow would push them back, and
/// the density would rise without bound.
///
///   m [kg], rho0 [kg/m^D], h half the support [m];  W_spacing  W at one spacing [1/m^D]
template <int D, class B, template <int> class Kernel> struct Sun2017 final : Shifting<D, B> {
  using typename Shifting<D, B>::Fluid;
  ConcentrationShifting<D, B, Kernel> shift;
  Real h;
  Sun2017(Kernel<D> W, Real m, Real rho0, Real h, Real W_spacing)
      : shift{W, m, rho0, W_spacing, {}, {}, {}}, h(h) {}

  void fields(FieldMaker<D>& maker) override { shift.fields(maker); }
  void find(B& backend, const Fluid& f, const Walls<D>& w, Real, PerLiquid,
            Field<Vec<D>>) override {
    const auto u = shift.u;
    const Real U = shift.fastest(backend, f);
    const Real factor = -2 * U * h, most = U / 2, inside = this->inside;
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

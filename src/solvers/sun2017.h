// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/wall_sets.h"
#include "pairs/sun2017.h"
#include "solvers/backend.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particle shifting [Sun, Colagrossi, Marrone, Zhang 2017]: after a step a particle goes on at
///
///   u_i = -2 U h crowd_i,  at most U/2,  U = max |v|                            [eq. 5, h = H/2]
///
/// from where its neighbours crowd: the paper's CFL Ma is U dt/h. It takes on the velocity and the
/// density that the flow has there [Lind 2012, eq. 33]. Particles of a free surface, which see less
/// than 0.75 D of their neighbours, stay; what sees a wall is moved along it only: the flow would
/// press it back, and the density would rise without end.
template <int D, class B, template <int> class Kernel> struct Sun2017 {
  using Fluid = FluidParticles<D>;
  Kernel<D> W;
  Real m, rho0, h, W_spacing;
  Field<Vec<D>> u;   ///< scratch: velocity of the shift [m/s]
  Field<Vec<D>> dv;  ///< scratch: rate of the velocity by it [m/s^2]
  Field<Real> drho;  ///< scratch: and of the density [kg/m^D/s]

  void fields(FieldMaker<D>& maker) {
    maker.make("shift", Keep::scratch, u);
    maker.make("shift_dv", Keep::scratch, dv);
    maker.make("shift_drho", Keep::scratch, drho);
  }

  // Public for nvcc, which takes no lambdas from private functions.
  /// u, dv and drho, by the particles and neighbours as they are; v is shared.
  void find(B& backend, const Fluid& fluid, const Walls<D>& w) const {
    const auto f = fluid;
    const auto u = this->u;
    const auto dv = this->dv;
    const auto drho = this->drho;
    const Real U = Real(std::sqrt(
        backend.max("shift", f, [=] FRESHET_LAMBDA(int i) { return double(norm2(f.v[i])); })));
    const Real factor = -2 * U * h, most = U / 2, inside = Real(0.75f) * D;
    backend.sum_pairs(
        "shift", f, over(f, Sun2017Crowd{W, m, W_spacing, f.rho}),
        over(w.akinci2012, Sun2017WallCrowd{W, m, rho0, W_spacing, w.akinci2012.psi}),
        over(w.adami2012, Sun2017WallCrowd{W, m, rho0, W_spacing, Field<Real>{}}),
        [=] FRESHET_LAMBDA(int i, const Sun2017Sums<D, Real>& sum) {
          const Real wall2 = norm2(sum.wall);
          const Vec<D> across = wall2 > 0 ? dot(sum.crowd, sum.wall) / wall2 * sum.wall : Vec<D>{};
          const Vec<D> at = factor * (sum.crowd - across);
          const Real fast = norm(at);
          u[i] = sum.div_x < inside ? Vec<D>{} : fast > most ? (most / fast) * at : at;
        });
    backend.sum_pairs("shift", f, over(f, ShiftedState{W, m, f.rho, f.v, u}),
                      [=] FRESHET_LAMBDA(int i, const ShiftedRates<D, Real>& sum) {
                        dv[i] = sum.v;
                        drho[i] = sum.rho;
                      });
  }
  void move(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    const auto u = this->u;
    const auto dv = this->dv;
    const auto drho = this->drho;
    backend.for_each("shift", f, [=] FRESHET_LAMBDA(int i) {
      f.x[i] += dt * u[i];
      f.v[i] += dt * dv[i];
      f.rho[i] += dt * drho[i];
    });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

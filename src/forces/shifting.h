// SPDX-License-Identifier: MIT
/// Particle shifting: it moves particles relative to the flow, which keeps them evenly spread.
#pragma once
#include "forces/force.h"
#include "pairs/lind2012.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Of the surface are particles whose -sum_j V_j x_ij · grad W_ij, D inside, is less.
template <int D> constexpr Real inside_from = Real(0.75f) * D;

/// Shifting along the gradient of the particle concentration. A shifted particle takes the velocity
/// and the density of the flow at its new place [Lind, Xu, Stansby, Rogers 2012, eq. 33].
template <int D, class B, template <int> class Kernel> struct ConcentrationShifting {
  using Fluid = FluidParticles<D>;
  Kernel<D> W;
  Real m, rho0, W_spacing;
  Field<Vec<D>> u;   ///< scratch: velocity of the shift [m/s]
  Field<Vec<D>> dv;  ///< scratch: velocity rate by the shift [m/s^2]
  Field<Real> drho;  ///< scratch: density rate by the shift [kg/(m^3 s)]

  void fields(FieldMaker<D>& maker) {
    maker.make("shift", Keep::scratch, u);
    maker.make("shift_dv", Keep::scratch, dv);
    maker.make("shift_drho", Keep::scratch, drho);
  }

  // Public for nvcc, which takes no lambdas from private functions.
  static Real fastest(B& backend, const Fluid& fluid) {
    const auto f = fluid;
    return Real(std::sqrt(
        backend.max("shift", f, [=] FRESHET_LAMBDA(int i) { return double(norm2(f.v[i])); })));
  }
  /// Calls finish(i, Lind2012Sums).
  template <class Finish>
  void sum_crowd(B& backend, const Fluid& f, const Walls<D>& w, const Finish& finish) const {
    backend.sum_pairs(
        "shift", f, over(f, Lind2012Crowd{W, m, W_spacing, f.rho}),
        over(w.akinci2012, Lind2012WallCrowd{W, m, rho0, W_spacing, w.akinci2012.psi}),
        over(w.adami2012, Lind2012WallCrowd{W, m, rho0, W_spacing, Field<Real>{}}), finish);
  }
  void find_change(B& backend, const Fluid& f) const {
    const auto dv = this->dv;
    const auto drho = this->drho;
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

/// Restricts shifting near a free surface to the tangential direction, for particles with a
/// neighbour that belongs to the surface.
template <int D, class B, template <int> class Kernel> struct ShiftingAtSurface {
  using Fluid = FluidParticles<D>;
  Kernel<D> W;
  Field<Vec<D>> edge;  ///< scratch: Lind2012Sums::slope at the free surface, zero elsewhere [1/m]

  void fields(FieldMaker<D>& maker) { maker.make("shift_edge", Keep::scratch, edge); }
  /// Removes the normal part of the shifts u near the free surface.
  void keep_along(B& backend, const Fluid& f, Field<Vec<D>> u) const {
    backend.share("shift", f, edge);
    backend.sum_pairs("shift", f, over(f, Lind2012Normal{W, edge}),
                      [=] FRESHET_LAMBDA(int i, Vec<D> normal) {
                        const Real n2 = norm2(normal);
                        if (n2 > 0) u[i] += (-dot(u[i], normal) / n2) * normal;
                      });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

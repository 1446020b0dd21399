// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/wall_sets.h"
#include "pairs/morris2000.h"
#include "solvers/backend.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Continuum surface force [Brackbill, Kothe, Zemach 1992; Morris 2000]. Within a support radius of
/// the free surface the force density on the liquid is
///
///   f_i = 2 sigma kappa_i n_i,  n_i = sum_j V grad W_ij                    [N/m^D; eq. 10]
///
/// The factor 2 is there because only the half inside the surface has particles. The curvature
/// kappa is computed from normals that are smoothed twice. It is extrapolated from the particle to
/// the surface, over the mean depth `depth`. Next to a wall, normals are projected onto it: the
/// contact angle is 90°.
///
///   m [kg], rho0 [kg/m^D], support, spacing [m]
template <int D, class B, template <int> class Kernel> struct Morris2000 {
  using Fluid = FluidParticles<D>;
  Kernel<D> W;
  Real m, rho0, support, spacing;
  Real depth;           ///< mean distance from the surface, weighted by |n| [m]
  bool alone;           ///< there are no walls to take up momentum
  Field<Vec<D>> n;      ///< scratch: gradient of the colour [1/m]
  Field<Vec<D>> once;   ///< scratch: n smoothed once [1/m]; then the acceleration [m/s^2]
  Field<Vec<D>> twice;  ///< scratch: n smoothed twice [1/m]

  void fields(FieldMaker<D>& maker) {
    maker.make("surface_normal", Keep::scratch, n);
    maker.make("surface_normal_once", Keep::scratch, once);
    maker.make("surface_normal_twice", Keep::scratch, twice);
  }
  Real V() const { return m / rho0; }

  // Public for nvcc, which takes no lambdas from private functions.
  void find_normals(B& backend, const Fluid& fluid, const Walls<D>& w) const {
    const auto f = fluid;
    const auto n = this->n;
    backend.sum_pairs("surface normal", f, over(f, Morris2000Normal{W, V()}),
                      over(w.akinci2012, Morris2000WallNormal{W, V(), rho0, w.akinci2012.psi}),
                      over(w.adami2012, Morris2000WallNormal{W, V(), rho0, Field<Real>{}}),
                      [=] FRESHET_LAMBDA(int i, const Morris2000Normals<D, Real>& sum) {
                        const Real wall2 = norm2(sum.wall);
                        n[i] = wall2 > 0 ? sum.fluid - dot(sum.fluid, sum.wall) / wall2 * sum.wall
                                         : sum.fluid;
                      });
  }
  void smooth(B& backend, const Fluid& fluid, Field<Vec<D>> from, Field<Vec<D>> to) const {
    const auto f = fluid;
    backend.share("surface normal", f, from);
    backend.sum_pairs("surface normal", f, over(f, Morris2000Smoothed{W, V(), from}),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) { to[i] = sum; });
  }
  /// push += 2 sigma kappa n lightness/rho0  [m/s^2]; sigma [N/m]
  void push(B& backend, const Fluid& fluid, const Walls<D>& w, const PerLiquid& sigma,
            const PerLiquid& lightness, Field<Vec<D>> push) const {
    const auto f = fluid;
    const auto acts = once;
    find_normals(backend, fluid, w);
    smooth(backend, fluid, n, once);
    smooth(backend, fluid, once, twice);
    find_force(backend, fluid, sigma);
    if (alone) balance(backend, fluid);
    backend.for_each("surface tension", f,
                     [=] FRESHET_LAMBDA(int i) { push[i] += lightness[i] * acts[i]; });
  }
  /// once = 2 sigma kappa n/rho0  [m/s^2], with kappa of the normals smoothed twice
  void find_force(B& backend, const Fluid& fluid, const PerLiquid& sigma) const {
    const auto f = fluid;
    const auto n = this->n;
    const auto acts = once;
    const auto smoothed = twice;
    const Real least = Real(0.2f) / support, depth = this->depth, rho0 = this->rho0;
    const Real most = Real(D - 1) / spacing;  // curvature of a drop whose radius is the spacing
    backend.share("surface normal", f, smoothed);
    backend.sum_pairs("surface tension", f, over(f, Morris2000Curvature{W, V(), least, smoothed}),
                      [=] FRESHET_LAMBDA(int i, const Morris2000Turn<D, Real>& sum) {
                        const bool seen = norm2(smoothed[i]) > least * least && sum.spread > 0;
                        const Real there = seen ? -Real(D - 1) * sum.turn / sum.spread : Real(0);
                        const Real within = max(-most, min(there, most));
                        const Real kappa = within / max(1 + within * depth / (D - 1), Real(0.5f));
                        acts[i] = 2 * sigma[i] * kappa / rho0 * n[i];
                      });
  }
  /// Subtracts the net force, weighted by |n|. Over a closed surface it is zero in the continuum;
  /// the discrete sum is not.
  void balance(B& backend, const Fluid& fluid) const {
    const auto f = fluid;
    const auto n = this->n;
    const auto acts = once;
    const double surface =
        backend.sum("surface tension", f, [=] FRESHET_LAMBDA(int i) { return double(norm(n[i])); });
    if (surface == 0) return;
    Vec<D> excess;
    for (int d = 0; d < D; ++d)
      component(excess, d) = Real(backend.sum("surface tension", f, [=] FRESHET_LAMBDA(int i) {
        Vec<D> a = acts[i];
        return double(component(a, d));
      }) / surface);
    backend.for_each("surface tension", f,
                     [=] FRESHET_LAMBDA(int i) { acts[i] = acts[i] - norm(n[i]) * excess; });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

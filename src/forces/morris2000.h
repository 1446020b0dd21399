// SPDX-License-Identifier: MIT
#pragma once
#include "forces/force.h"
#include "pairs/morris2000.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Continuum surface force [Brackbill, Kothe, Zemach 1992; Morris 2000]. Within a support radius of
/// the free surface the force density on the liquid is
///
///   f_i = 2 sigma kappa_i n_i,  n_i = sum_j V grad W_ij                    [N/m^3; eq. 10]
///
/// twice, since only the half inside the surface has particles to push. The curvature kappa is that
/// of normals smoothed twice, and is taken from a particle's depth, the mean of |x| in W, to the
/// surface. Beside a wall normals lie along it: the angle of contact is 90°.
template <int D, class B, template <int> class Kernel> struct Morris2000 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  ForceParameters<D> c;
  Kernel<D> W;
  Field<Vec<D>> n;      ///< scratch: the colour's gradient [1/m]
  Field<Vec<D>> once;   ///< scratch: smoothed once; at last the force [m/s^2]
  Field<Vec<D>> twice;  ///< scratch: smoothed twice

  Morris2000(const ForceParameters<D>& c, Kernel<D> W) : c(c), W(W) {}
  static bool acts(const ForceParameters<D>& c) {
    return c.tension == SurfaceTensionMethod::morris2000;
  }

  void fields(FieldMaker<D>& maker) override {
    maker.make("surface_normal", Keep::scratch, n);
    maker.make("surface_normal_once", Keep::scratch, once);
    maker.make("surface_normal_twice", Keep::scratch, twice);
  }
  void bound(TimeStepBounds& bounds) const override { bound_by_tension(c, bounds); }
  Real V() const { return c.m / c.rho0; }

  // Public for nvcc, which takes no lambdas from private functions.
  void find_normals(B& backend, const Fluid& fluid, const Walls<D>& w) const {
    const auto f = fluid;
    const auto n = this->n;
    backend.sum_pairs("surface normal", f, over(f, Morris2000Normal{W, V()}),
                      over(w.akinci2012, Morris2000WallNormal{W, V(), c.rho0, w.akinci2012.psi}),
                      over(w.adami2012, Morris2000WallNormal{W, V(), c.rho0, Field<Real>{}}),
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
  /// push += 2 sigma kappa n/rho.
  void add(B& backend, const Fluid& fluid, const Walls<D>& w, Real, Field<Vec<D>> push) override {
    const auto f = fluid;
    const auto acts = once;
    const PerLiquid lightness = c.liquids.each(&Liquid::lightness, f);
    find_normals(backend, fluid, w);
    smooth(backend, fluid, n, once);
    smooth(backend, fluid, once, twice);
    find_force(backend, fluid);
    if (c.no_walls) balance(backend, fluid);
    backend.for_each("surface tension", f,
                     [=] FRESHET_LAMBDA(int i) { push[i] += lightness[i] * acts[i]; });
  }
  /// once = 2 sigma kappa n/rho0, by the normals smoothed twice
  void find_force(B& backend, const Fluid& fluid) const {
    const auto f = fluid;
    const PerLiquid sigma = c.liquids.each(&Liquid::sigma, f);
    const auto n = this->n;
    const auto acts = once;
    const auto smoothed = twice;
    const Real least = Real(0.2f) / c.support, depth = c.depth, rho0 = c.rho0;
    const Real most = Real(D - 1) / c.spacing;  // of a drop with the spacing for a radius
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

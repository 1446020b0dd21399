// SPDX-License-Identifier: MIT
#pragma once
#include "forces/force.h"
#include "pairs/akinci2013.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The surface tension and adhesion of pairs/akinci2013.h.
template <int D, class B, template <int> class Kernel> struct Akinci2013 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  ForceParameters<D> c;
  Kernel<D> W;
  Field<Vec<D>> n;  ///< scratch: the surface normal
  Akinci2013(const ForceParameters<D>& c, Kernel<D> W) : c(c), W(W) {}
  static bool acts(const ForceParameters<D>& c) {
    return c.tension == SurfaceTensionMethod::akinci2013;
  }

  void fields(FieldMaker<D>& maker) override { maker.make("surface_normal", Keep::scratch, n); }
  void add(B& backend, const Fluid& fluid, const Walls<D>& w, Real, Field<Vec<D>> push) override {
    const auto f = fluid;
    const auto normal = n;
    backend.sum_pairs("surface normal", f, over(f, Akinci2013Normal{W, c.support, c.m, f.rho}),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) { normal[i] = sum; });
    backend.share("surface normal", f, normal);
    backend.sum_pairs("surface tension", f, over(f, tension(f)), over(w.akinci2012, adhesion(f, w)),
                      AddTo<D>{push, c.liquids.each(&Liquid::lightness, f)});
  }
  void bound(TimeStepBounds& bounds) const override { bound_by_tension(c, bounds); }
  void add_wall_forces(const Fluid& f, const Walls<D>& w, WallForces<D, B>& forces) const override {
    forces.add(w.akinci2012, f, adhesion(f, w));
  }

  Real per_mass() const { return Real(1 / (double(c.rho0) * std::pow(double(c.support), D))); }
  auto tension(const Fluid& f) const {
    return Akinci2013Tension<D>{
        c.support, c.rho0, c.m * per_mass(), c.liquids.each(&Liquid::gamma, f), f.rho, n};
  }
  auto adhesion(const Fluid& f, const Walls<D>& w) const {
    return Akinci2013Adhesion<D>{c.support, per_mass(), c.liquids.each(&Liquid::beta, f),
                                 w.akinci2012.psi};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

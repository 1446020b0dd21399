// SPDX-License-Identifier: MIT
#pragma once
#include "forces/force.h"
#include "pairs/morris1997.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The viscosity of pairs/morris1997.h, explicit in time.
template <int D, class B, template <int> class Kernel> struct Morris1997 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  ForceParameters<D> c;
  Kernel<D> W;
  Morris1997(const ForceParameters<D>& c, Kernel<D> W) : c(c), W(W) {}
  static bool acts(const ForceParameters<D>& c) {
    return c.viscosity == ViscosityMethod::morris1997;
  }

  void add(B& backend, const Fluid& f, const Walls<D>& w, Real, Field<Vec<D>> push) override {
    backend.sum_pairs("viscosity", f, over(f, inside(f)), over(w.akinci2012, at_akinci(f, w)),
                      over(w.adami2012, at_adami(f, w)),
                      AddTo<D>{push, c.liquids.each(&Liquid::lightness, f)});
  }
  void bound(TimeStepBounds& bounds) const override { bound_by_viscosity(c, bounds); }
  void add_wall_forces(const Fluid& f, const Walls<D>& w, WallForces<D, B>& forces) const override {
    forces.add(w.akinci2012, f, at_akinci(f, w));
    forces.add(w.adami2012, f, at_adami(f, w));
    forces.add_ghosts(f, inside(f));
  }

  auto inside(const Fluid& f) const {
    return Morris1997Viscosity{W, c.m, c.eps_h2(), c.liquids.each(&Liquid::mu, f), f.rho, f.v};
  }
  auto at_akinci(const Fluid& f, const Walls<D>& w) const {
    return Morris1997Akinci{W,   c.eps_h2(),       c.liquids.each(&Liquid::mu, f), f.rho,
                            f.v, w.akinci2012.psi, w.akinci2012.friction};
  }
  auto at_adami(const Fluid& f, const Walls<D>& w) const {
    return Morris1997Adami{W,
                           c.m,
                           c.rho0,
                           c.eps_h2(),
                           c.liquids.each(&Liquid::mu, f),
                           f.rho,
                           f.v,
                           w.adami2012.friction,
                           w.adami2012.v};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "forces/force.h"
#include "pairs/monaghan2005.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The viscosity of pairs/monaghan2005.h, explicit in time.
template <int D, class B, template <int> class Kernel> struct Monaghan2005 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  ForceParameters<D> c;
  Kernel<D> W;
  Monaghan2005(const ForceParameters<D>& c, Kernel<D> W) : c(c), W(W) {}
  static bool acts(const ForceParameters<D>& c) {
    return c.viscosity == ViscosityMethod::monaghan2005;
  }

  void add(B& backend, const Fluid& f, const Walls<D>& w, Real, Field<Vec<D>> push) override {
    backend.sum_pairs("viscosity", f, over(f, inside(c, W, f)),
                      over(w.akinci2012, at_akinci(c, W, f, w)),
                      over(w.adami2012, at_adami(c, W, f, w, false)),
                      AddTo<D>{push, c.liquids.each(&Liquid::lightness, f)});
  }
  void bound(TimeStepBounds& bounds) const override { bound_by_viscosity(c, bounds); }
  void add_wall_forces(const Fluid& f, const Walls<D>& w, WallForces<D, B>& forces) const override {
    add_reactions(c, W, f, w, false, forces);
  }

  // The terms, also for the walls of Weiler 2018, whose layers are at rest.
  static auto inside(const ForceParameters<D>& c, Kernel<D> W, const Fluid& f) {
    return Monaghan2005Viscosity{W, c.m, c.eps_h2(), c.liquids.each(&Liquid::mu, f), f.rho, f.v};
  }
  static auto at_akinci(const ForceParameters<D>& c, Kernel<D> W, const Fluid& f,
                        const Walls<D>& w) {
    return Monaghan2005Akinci{W,   c.eps_h2(),       c.liquids.each(&Liquid::mu, f), f.rho,
                              f.v, w.akinci2012.psi, w.akinci2012.friction};
  }
  static auto at_adami(const ForceParameters<D>& c, Kernel<D> W, const Fluid& f, const Walls<D>& w,
                       bool at_rest) {
    return Monaghan2005Adami{W,
                             c.m,
                             c.rho0,
                             c.eps_h2(),
                             c.liquids.each(&Liquid::mu, f),
                             f.rho,
                             f.v,
                             w.adami2012.friction,
                             w.adami2012.v,
                             at_rest};
  }
  static void add_reactions(const ForceParameters<D>& c, Kernel<D> W, const Fluid& f,
                            const Walls<D>& w, bool at_rest, WallForces<D, B>& forces) {
    forces.add(w.akinci2012, f, at_akinci(c, W, f, w));
    forces.add(w.adami2012, f, at_adami(c, W, f, w, at_rest));
    forces.add_ghosts(f, inside(c, W, f));
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "pairs/akinci2012.h"
#include "pairs/becker2007_forces.h"
#include "pairs/density.h"
#include "pairs/reaction.h"
#include "solvers/time_step.h"
#include "solvers/weakly_compressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The fluid fields of WCSPH.
template <int D> struct WcsphFluid : FluidParticles<D> {
  Field<Vec<D>> v_memory;  ///< kept: velocity earlier in the step; not with symplectic Euler

  template <class Visit> void fields(Integrator integrator, Visit visit) {
    const bool starts_with_a = integrator != Integrator::symplectic_euler;
    visit("a", starts_with_a ? Keep::kept : Keep::scratch, this->a);
    if (starts_with_a) visit("v_memory", Keep::kept, v_memory);
    visit("rho", Keep::scratch, this->rho);
    visit("p", Keep::scratch, this->p);
  }
  template <class F> FRESHET_HD void evolve(int i, const F& f) const {
    f(i, this->v, this->a, v_memory);
  }
};

/// Weakly compressible SPH for free surface flows [Becker and Teschner 2007]: density by summation,
/// Tait's equation, artificial viscosity. Negative pressures are set to zero, so that missing
/// neighbours at the free surface do not cause tension.
template <int D, Backend<D> B, template <int> class Kernel> struct Wcsph {
  using Fluid = WcsphFluid<D>;
  WeaklyCompressibleParameters<D> c;
  Kernel<D> W;
  NonPressureForces<D, B>* forces = nullptr;  ///< forces beside pressure; null: none

  template <class Visit> void fields(Fluid& f, Visit visit) const { f.fields(c.integrator, visit); }

  void step(B& backend, Fluid& fluid, Walls<D>& walls, const Tick& t) const {
    integrate_with(backend, c, fluid, walls, t, forces, [&] { accelerate(backend, fluid, walls); });
  }

  TimeStepBounds bounds(B& backend, const Fluid& f) const {
    return time_step_bounds(backend, f, double(c.h), c.fastest_sound(), c.artificial_nu());
  }

  /// The pair terms of the forces; wall forces and bodies use them as well.
  auto fluid_forces(const Fluid& f) const {
    return Becker2007Forces{W, Pi(), c.m, f.p, f.rho, f.v};
  }
  auto akinci2012_forces(const Fluid& f, const AkinciWall<D>& w) const {
    return Akinci2012Forces{W, Pi(), f.p, f.rho, f.v, w.psi, w.friction, w.v};
  }
  auto adami2012_forces(const Fluid& f, const AdamiWall<D>& w) const {
    return Adami2012Forces{W, Pi(), c.m, c.rho0, f.p, f.rho, f.v, w.p, w.friction, w.v};
  }
  auto monaghan2009_forces(const Fluid&, const Walls<D>&) const {
    return Monaghan2009Repulsion<D>{c.repulsion(), c.h};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  ArtificialViscosity Pi() const { return {2 * c.alpha * c.h * c.c0, c.eps_h2()}; }

  void accelerate(B& backend, Fluid& fluid, const Walls<D>& w) const {
    backend.find_neighbors("neighbors", c.support, fluid, w.akinci2012, w.adami2012,
                           w.monaghan2009);
    const auto f = fluid;
    show_bodies(backend, w, f, c.support);
    const Kernel<D> W = this->W;
    const Real rho0 = c.rho0, B_tait = c.B(), background = c.background;
    const Vec<D> g = c.gravity;
    const Liquids liquids = c.liquids;
    const Density density{W, c.m_density};
    backend.sum_pairs("density", f, over(f, density),
                      over(w.akinci2012, Akinci2012Density{W, w.akinci2012.psi}),
                      over(w.adami2012, density), [=] FRESHET_LAMBDA(int i, Real sum) {
                        f.rho[i] = sum;                                                    // eq. 4
                        f.p[i] = max(tait(B_tait, f.rho[i] / rho0, background), Real(0));  // eq. 7
                      });
    backend.share("rho, p", f, f.rho, f.p);
    extrapolate_to_walls(backend, w, f, W, c);
    backend.sum_pairs("forces", f, over(f, fluid_forces(f)),
                      over(w.akinci2012, akinci2012_forces(f, w.akinci2012)),
                      over(w.adami2012, adami2012_forces(f, w.adami2012)),
                      over(w.monaghan2009, monaghan2009_forces(f, w)),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) {
                        f.a[i] = liquids.lightness(f, i) * sum + g;
                      });  // eq. 5
    ask_bodies(backend, w, f, akinci2012_forces(f, w.of_bodies),
               adami2012_forces(f, w.of_layered_bodies));
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

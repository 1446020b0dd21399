// SPDX-License-Identifier: MIT
#pragma once
#include "pairs/antuono2010_diffusion.h"
#include "pairs/delta_sph_rates.h"
#include "solvers/time_step.h"
#include "solvers/weakly_compressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The fluid fields of delta-SPH. rho is kept, because it is advanced in time.
template <int D> struct DeltaSphFluid : FluidParticles<D> {
  Field<Real> drho;        ///< density rate [kg/(m^3 s)]
  Field<Vec<D>> v_memory;  ///< kept: velocity earlier in the step; not with symplectic Euler
  Field<Real> rho_memory;  ///< kept: density earlier in the step; not with symplectic Euler
  Field<Real> diffusion;   ///< scratch: density rate by diffusion; Antuono's diffusion only
  Field<Vec<D>> density_gradient;  ///< scratch; Antuono's diffusion only

  template <class Visit> void fields(Integrator integrator, bool antuono, Visit visit) {
    const bool starts_with_rates = integrator != Integrator::symplectic_euler;
    const Keep rates = starts_with_rates ? Keep::kept : Keep::scratch;
    visit("rho", Keep::kept, this->rho);
    visit("a", rates, this->a);
    visit("drho", rates, drho);
    if (starts_with_rates) {
      visit("v_memory", Keep::kept, v_memory);
      visit("rho_memory", Keep::kept, rho_memory);
    }
    visit("p", Keep::scratch, this->p);
    if (antuono) {
      visit("diffusion", Keep::scratch, diffusion);
      visit("density_gradient", Keep::scratch, density_gradient);
    }
  }
  template <class F> FRESHET_HD void evolve(int i, const F& f) const {
    f(i, this->v, this->a, v_memory);
    f(i, this->rho, drho, rho_memory);
  }
};

/// Free-surface flows by SPH with numerical diffusive terms [Antuono, Colagrossi, Marrone, Molteni
/// 2010]. The density follows from the continuity equation with diffusion, the pressure from Tait's
/// equation. A bulk viscosity a h c0 div v damps sound [Sun, Pilloton, Antuono, Colagrossi 2023,
/// the acoustic damper]: it is the pressure a h c0 Drho/Dt, with the last known rate, which needs
/// no pass of its own.
template <int D, Backend<D> B, template <int> class Kernel> struct DeltaSph {
  using Fluid = DeltaSphFluid<D>;
  WeaklyCompressibleParameters<D> c;
  Kernel<D> W;
  NonPressureForces<D, B>* forces = nullptr;  ///< forces beside pressure; null: none

  template <class Visit> void fields(Fluid& f, Visit visit) const {
    f.fields(c.integrator, c.antuono, visit);
  }

  void step(B& backend, Fluid& fluid, Walls<D>& walls, const Tick& t) const {
    integrate_with(backend, c, fluid, walls, t, forces,
                   [&] { evaluate_rates(backend, fluid, walls, t); });
  }

  TimeStepBounds bounds(B& backend, const Fluid& f) const {
    return time_step_bounds(backend, f, double(c.h), c.fastest_sound(), c.artificial_nu());
  }

  /// The pair terms of the rates; wall forces and bodies use them as well.
  auto fluid_forces(const Fluid& f) const {
    DeltaSphNumbers numbers = this->numbers();
    if (c.antuono) numbers.delta_h_c = 0;  // diffuse() computes it in a separate pass
    const Vec<D> G = c.rho0 / (c.c0 * c.c0) * c.gravity;
    return DeltaSphRates{W, numbers, G, f.p, f.rho, f.v};
  }
  auto akinci2012_forces(const Fluid& f, const AkinciWall<D>& w) const {
    return DeltaSphAkinciRates{W, numbers(), f.p, f.rho, f.v, w.psi, w.friction, w.v};
  }
  auto adami2012_forces(const Fluid& f, const AdamiWall<D>& w) const {
    return DeltaSphAdamiRates{W, numbers(), f.p, f.rho, f.v, w.p, w.friction, w.v};
  }
  auto monaghan2009_forces(const Fluid&, const Walls<D>&) const {
    return AsRates<D, Monaghan2009Repulsion<D>>{{c.repulsion(), c.h}};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  DeltaSphNumbers numbers() const {
    return {c.m, c.rho0, c.alpha * c.h * c.c0, c.delta * c.h * c.c0, c.eps_h2()};
  }

  /// Computes a and drho. With symplectic Euler the density advances first, with the velocity that
  /// moved the particles; otherwise the scheme would be explicit Euler for sound, which is unstable
  /// for any step. The other integrators predict velocity and density in the same way and need one
  /// pass.
  void evaluate_rates(B& backend, Fluid& fluid, const Walls<D>& w, const Tick& t) const {
    backend.find_neighbors("neighbors", c.support, fluid, w.akinci2012, w.adami2012,
                           w.monaghan2009);
    const auto f = fluid;
    const Real rho0 = c.rho0, B_tait = c.B(), background = c.background;
    show_bodies(backend, w, f, c.support);
    const bool density_first = c.integrator == Integrator::symplectic_euler;
    backend.share("rho", f, f.rho);
    if (w.of_layered_bodies.n > 0) sum_moving_rate(backend, f, w);
    if (c.antuono) diffuse(backend, f);
    SetRates finish{f, moving_rate(w), c.liquids, c.gravity, t.dt, c.antuono, density_first};
    finish.advances = density_first;
    if (density_first) sum_rates(backend, f, w, "continuity", finish);
    const Real bulk = c.acoustic_damping * c.h * c.c0;
    backend.for_each("pressure", f, [=] FRESHET_LAMBDA(int i) {
      f.p[i] = tait(B_tait, f.rho[i] / rho0, background) + bulk * f.drho[i];
    });
    backend.share("rho, p", f, f.rho, f.p);
    extrapolate_to_walls(backend, w, f, W, c);
    finish.advances = false;
    sum_rates(backend, f, w, "rates", finish);
    ask_bodies(backend, w, f, akinci2012_forces(f, w.of_bodies),
               adami2012_forces(f, w.of_layered_bodies));
  }

  /// The finish of both passes. It is one struct, so that the pair sums are compiled once.
  struct SetRates {
    Fluid f;
    Field<Real> moving_rate;
    Liquids liquids;
    Vec<D> g;
    Real dt;
    bool diffuses, density_first;
    bool advances = false;  ///< rho += dt drho; else a and drho become the rates
    FRESHET_HD void operator()(int i, const DeltaSphSum<D, Real>& sum) const {
      if (advances) {
        f.drho[i] = density_rate(f, moving_rate, diffuses, i, sum.drho);
        f.rho[i] += dt * f.drho[i];
        return;
      }
      f.a[i] = liquids.lightness(f, i) * sum.a + g;
      f.drho[i] = density_first ? 0 : density_rate(f, moving_rate, diffuses, i, sum.drho);
    }
  };
  /// Drho_i/Dt: the sum with the rates of the separate passes for bodies and diffusion.
  FRESHET_HD static Real density_rate(const Fluid& f, Field<Real> moving_rate, bool diffuses, int i,
                                      Real sum) {
    if (moving_rate.data) sum -= moving_rate[i];
    return diffuses ? sum + f.diffusion[i] : sum;
  }

  void sum_rates(B& backend, const Fluid& f, const Walls<D>& w, const char* name,
                 const SetRates& finish) const {
    backend.sum_pairs(name, f, over(f, fluid_forces(f)),
                      over(w.akinci2012, akinci2012_forces(f, w.akinci2012)),
                      over(w.adami2012, adami2012_forces(f, w.adami2012)),
                      over(w.monaghan2009, monaghan2009_forces(f, w)), finish);
  }

  /// No memory for body particles of akinci2012, whose velocities are in the pair terms.
  static Field<Real> moving_rate(const Walls<D>& w) {
    return w.of_layered_bodies.n > 0 ? w.rate : Field<Real>{};
  }
  /// The density rate by moving bodies of adami2012, which is subtracted from drho.
  void sum_moving_rate(B& backend, const Fluid& f, const Walls<D>& w) const {
    const auto rho = f.rho, rate = w.rate;
    backend.sum_pairs("bodies: rate", f,
                      over(w.adami2012, Adami2012MovingRate{W, c.m / c.rho0, w.adami2012.u}),
                      [=] FRESHET_LAMBDA(int i, Real sum) { rate[i] = rho[i] * sum; });
  }

  void diffuse(B& backend, const Fluid& f) const {
    const auto gradient = f.density_gradient;
    const auto diffusion = f.diffusion;
    backend.sum_pairs("density gradient", f, over(f, DensityGradient{W, c.m, f.rho}),
                      [=] FRESHET_LAMBDA(int i, const RenormalizedSums<D, Real>& sum) {
                        gradient[i] = sum.renormalized();
                      });
    backend.share("density gradient", f, gradient);
    const DeltaSphNumbers n = numbers();
    backend.sum_pairs("diffusion", f,
                      over(f, Antuono2010Diffusion{W, c.m, n.delta_h_c, n.eps_h2, f.rho, gradient}),
                      [=] FRESHET_LAMBDA(int i, Real sum) { diffusion[i] = sum; });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

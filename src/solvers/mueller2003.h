// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/box_walls.h"
#include "kernels/poly6.h"
#include "pairs/density.h"
#include "pairs/mueller2003_forces.h"
#include "solvers/backend.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct Mueller2003Parameters {
  Real dt, h;         ///< time step [s], support radius [m]
  Real m, m_density;  ///< mass [kg]; mass over Poly6's lattice sum [kg]
  Real rho0, k, mu;   ///< rest density [kg/m^D], stiffness [m^2/s^2], viscosity [Pa s]
  Vec<D> gravity;     ///< [m/s^2]
  BoxWalls<D> walls;
  bool kick_drift;    ///< the article's integrator, else kick-drift-kick
  Real spiky_factor;  ///< Spiky<D>::derivative, or the article's 10
  Real speed_limit;   ///< [m/s]; the article's scheme only
};

template <int D> struct Mueller2003Fluid : Particles<D> {
  Field<Vec<D>> a;       ///< kept: acceleration, for the first kick of the next step
  Field<Vec<D>> v_half;  ///< kept (the search sorts within a step): velocity at its middle
  Field<Real> rho, p;    ///< scratch

  template <class Visit> void fields(Visit visit) {
    visit("a", Keep::kept, a);
    visit("v_half", Keep::kept, v_half);
    visit("rho", Keep::scratch, rho);
    visit("p", Keep::scratch, p);
  }
};

/// Particle-based fluid simulation for interactive applications [Mueller, Charypar, Gross 2003].
template <int D, Backend<D> B> struct Mueller2003 {
  using Fluid = Mueller2003Fluid<D>;
  Mueller2003Parameters<D> c;

  void step(B& backend, Fluid& f, bool first) {
    if (c.kick_drift) return step_kick_drift(backend, f);
    if (first) accelerate(backend, f);
    step_kick_drift_kick(backend, f);
  }

 private:
  /// Leapfrog in its kick-drift-kick form (section 5): second order. Viscosity needs v at the end
  /// of the step before it is known; the old acceleration predicts it.
  void step_kick_drift_kick(B& backend, const Fluid& fluid) const {
    const auto c = this->c;
    const auto f = fluid;
    backend.for_each("kick, drift", f, [=] FRESHET_LAMBDA(int i) {
      f.v_half[i] = f.v[i] + c.dt / 2 * f.a[i];
      f.x[i] += c.dt * f.v_half[i];
      c.walls(f.x[i], f.v_half[i]);
      f.v[i] = f.v_half[i] + c.dt / 2 * f.a[i];
    });
    accelerate(backend, f);
    backend.for_each("kick", f,
                     [=] FRESHET_LAMBDA(int i) { f.v[i] = f.v_half[i] + c.dt / 2 * f.a[i]; });
  }

  /// The article's integrator: one kick, one drift, both of the whole step. Started from x and v of
  /// the same time this is symplectic Euler: first order.
  void step_kick_drift(B& backend, const Fluid& fluid) const {
    const auto c = this->c;
    const auto f = fluid;
    accelerate(backend, f);
    backend.for_each("kick, drift", f, [=] FRESHET_LAMBDA(int i) {
      f.v[i] += c.dt * f.a[i];
      f.x[i] += c.dt * f.v[i];
      const Real speed = norm(f.v[i]);
      if (speed > c.speed_limit) f.v[i] = c.speed_limit / speed * f.v[i];
      c.walls(f.x[i], f.v[i]);
    });
  }

  /// rho and p, then a = (f^pressure + f^viscosity)/rho + g.
  void accelerate(B& backend, const Fluid& fluid) const {
    const auto c = this->c;
    const auto f = fluid;
    backend.find_neighbors("neighbors", c.h, f);
    backend.sum_pairs("density", f, over(f, Density{Poly6<D>(c.h), c.m_density}),
                      [=] FRESHET_LAMBDA(int i, Real sum) {
                        f.rho[i] = sum;                      // eq. 3
                        f.p[i] = c.k * (f.rho[i] - c.rho0);  // eq. 12
                      });
    backend.share("rho, p", f.rho, f.p);
    const Mueller2003Forces<D> forces{
        Spiky<D>(c.h, c.spiky_factor), ViscosityKernel<D>(c.h), c.m, c.mu, f.p, f.rho, f.v};
    backend.sum_pairs("forces", f, over(f, forces),
                      [=] FRESHET_LAMBDA(int i, ForceDensities<D, Real> sum) {
                        f.a[i] = (sum.pressure + sum.viscosity) / f.rho[i] + c.gravity;  // eq. 8
                      });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

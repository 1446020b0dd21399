// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "kernels/poly6.h"
#include "pairs/density.h"
#include "pairs/mueller2003_forces.h"
#include "solvers/backend.h"
#include "solvers/integrators.h"
#include "solvers/time_step.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct Mueller2003Parameters {
  Real h;             ///< support radius [m]
  Real m, m_density;  ///< mass [kg/m^(3-D)]; mass over Poly6's lattice sum [kg/m^(3-D)]
  Real rho0, k, mu;   ///< rest density [kg/m^3], stiffness [m^2/s^2], viscosity [Pa s]
  Vec<D> gravity;     ///< [m/s^2]
  Liquids liquids;    ///< exactly one
  Confinement<D> confine;
  Integrator integrator;
  bool article;       ///< use the article's step, which limits speeds
  Real spiky_factor;  ///< Spiky<D>::derivative, or the article's 10
  Real speed_limit;   ///< [m/s]; the article's step only
};

/// The fluid fields of Mueller 2003. a is kept, because the first kick of the next step uses it.
template <int D> struct Mueller2003Fluid : FluidParticles<D> {
  Field<Vec<D>> v_memory;  ///< velocity at mid-step; kept, because the search sorts within a step

  template <class Visit> void fields(Visit visit) {
    visit("a", Keep::kept, this->a);
    visit("v_memory", Keep::kept, v_memory);
    visit("rho", Keep::scratch, this->rho);
    visit("p", Keep::scratch, this->p);
  }
  template <class F> FRESHET_HD void evolve(int i, const F& f) const {
    f(i, this->v, this->a, v_memory);
  }
};

/// The article's integrator: one kick and one drift, both of the whole step. It starts from x and v
/// of the same time, so it is symplectic Euler: first order.
template <int D> struct ArticleStep {
  Mueller2003Fluid<D> f;
  Confinement<D> confine;
  Real dt, speed_limit;
  FRESHET_HD void operator()(int i) const {
    f.v[i] += dt * f.a[i];
    const Vec<D> from = f.x[i];
    f.x[i] += dt * f.v[i];
    const Real speed = norm(f.v[i]);
    if (speed > speed_limit) f.v[i] = speed_limit / speed * f.v[i];
    confine(i, f, f.v[i], from);
  }
};

/// Particle-based fluid simulation for interactive applications [Mueller, Charypar, Gross 2003].
template <int D, Backend<D> B> struct Mueller2003 {
  using Fluid = Mueller2003Fluid<D>;
  Mueller2003Parameters<D> c;

  template <class Visit> void fields(Fluid& f, Visit visit) const { f.fields(visit); }

  void step(B& backend, Fluid& f, Walls<D>&, const Tick& t) const {
    if (!c.article)
      return integrate(backend, c.integrator, f, c.confine, t, [&] { accelerate(backend, f); });
    accelerate(backend, f);
    backend.for_each("kick, drift", f, ArticleStep<D>{f, c.confine, t.dt, c.speed_limit});
  }

  TimeStepBounds bounds(B& backend, const Fluid& f) const {
    return time_step_bounds(backend, f, double(c.h) / 2, std::sqrt(double(c.k)),
                            double(c.mu) / double(c.rho0));
  }

  /// The pair term of the forces: force densities [N/m^3].
  auto fluid_forces(const Fluid& f) const {
    return Mueller2003Forces<D>{
        Spiky<D>(c.h, c.spiky_factor), ViscosityKernel<D>(c.h), c.m, c.mu, f.p, f.rho, f.v};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  /// Computes rho and p, then a = (f^pressure + f^viscosity)/rho + g.
  void accelerate(B& backend, Fluid& fluid) const {
    backend.find_neighbors("neighbors", c.h, fluid);
    const auto c = this->c;
    const auto f = fluid;
    backend.sum_pairs("density", f, over(f, Density{Poly6<D>(c.h), c.m_density}),
                      [=] FRESHET_LAMBDA(int i, Real sum) {
                        f.rho[i] = sum;                      // eq. 3
                        f.p[i] = c.k * (f.rho[i] - c.rho0);  // eq. 12
                      });
    backend.share("rho, p", f, f.rho, f.p);
    backend.sum_pairs("forces", f, over(f, fluid_forces(f)),
                      [=] FRESHET_LAMBDA(int i, ForceDensities<D, Real> sum) {
                        f.a[i] = (sum.pressure + sum.viscosity) / f.rho[i] + c.gravity;  // eq. 8
                      });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

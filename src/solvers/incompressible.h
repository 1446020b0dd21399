// SPDX-License-Identifier: MIT
/// What the solvers share that solve for the pressure, so that the density stays what it is.
#pragma once
#include <array>
#include <cmath>
#include <utility>

#include "boundary/confinement.h"
#include "core/fluid_particles.h"
#include "freshet/time_step.h"
#include "pairs/density_and_response.h"
#include "pairs/density_rate.h"
#include "pairs/laminar_viscosity.h"
#include "pairs/monaghan2009.h"
#include "pairs/pressure_acceleration.h"
#include "solvers/body_coupling.h"
#include "solvers/integrators.h"
#include "solvers/non_pressure_forces.h"
#include "solvers/solve.h"
#include "solvers/time_step.h"
#include "solvers/wall_samples.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct IncompressibleParameters {
  Real support, h;    ///< support radius, half of it [m]
  Real m, m_density;  ///< mass [kg]; mass over the kernel's lattice sum [kg]
  Real rho0;          ///< rest density [kg/m^D]
  Liquids liquids;
  Real most_nu, xsph;  ///< the greatest kinematic viscosity [m^2/s]; XSPH's share a step
  Real repulsion;      ///< K of the repulsive walls [m^2/s^2]
  Real response;       ///< of a particle in a resting lattice (pairs/density_and_response.h)
  Real stiffness;      ///< the equations' greatest eigenvalue over their diagonal, there
  Vec<D> gravity;      ///< [m/s^2]
  Confinement<D> confine;
  bool warm_start, accelerated;
  Iterations density, divergence;

  Real eps_h2() const { return Real(0.01f) * h * h; }
  /// How long a step of Jacobi's may be: as the paper has it, but with room below the longest that
  /// converges, 2/stiffness.
  Real relaxation(Real papers) const { return min(papers, Real(1.6f) / stiffness); }
};

template <int D> struct IncompressibleFluid : FluidParticles<D> {
  Field<Real> k;       ///< kept: p/rho^2
  Field<Real> factor;  ///< scratch: 1/response, 0 where nothing answers
  Field<Real> excess;  ///< scratch: what a solve has to remove [kg/m^D]
  template <class Visit> void fields(Visit visit) {
    visit("k", Keep::kept, k);
    visit("a", Keep::scratch, this->a);
    visit("rho", Keep::scratch, this->rho);
    visit("p", Keep::scratch, this->p);
    visit("factor", Keep::scratch, factor);
    visit("excess", Keep::scratch, excess);
  }
};

template <int D, Backend<D> B, template <int> class Kernel, class FluidT> struct Incompressible {
  using Fluid = FluidT;
  IncompressibleParameters<D> c;
  Kernel<D> W;
  NonPressureForces<D, B>* forces = nullptr;  ///< what else acts, if anything

  template <class Visit> void fields(Fluid& f, Visit visit) const { f.fields(visit); }
  void prepare(B& backend, Walls<D>& walls) const { prepare_walls(backend, walls, W, c); }

  /// Without sound, what is left of its bound is the flow's: none may cross 0.4 h in a step.
  TimeStepBounds bounds(B& backend, const Fluid& f) const {
    TimeStepBounds b = time_step_bounds(backend, f, double(c.h), 0, double(c.most_nu));
    std::swap(b.acoustic, b.flow);
    return b;
  }

  /// The pair terms of the forces, for what else asks who pushes whom.
  auto fluid_forces(const Fluid& f) const { return PressureAcceleration{W, c.m, f.k}; }
  auto fluid_friction(const Fluid& f, Real xsph_rate = 0) const {
    return LaminarViscosity{W, c.m, c.liquids, c.eps_h2(), xsph_rate, f};
  }
  auto akinci2012_forces(const Fluid& f, const AkinciWall<D>& w) const {
    return akinci2012_forces(f.k, w);
  }
  auto akinci2012_forces(Field<Real> k, const AkinciWall<D>& w) const {
    return Akinci2012PressureAcceleration{W, k, w.psi};
  }
  auto akinci2012_friction(const Fluid& f, const AkinciWall<D>& w) const {
    return Akinci2012Friction{W, c.liquids, c.eps_h2(), f, w.psi, w.friction, w.v};
  }
  auto monaghan2009_forces(const Fluid&, const Walls<D>&) const {
    return Monaghan2009Repulsion<D>{c.repulsion, c.h};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  void find_neighbors(B& backend, Fluid& fluid, const Walls<D>& w) const {
    backend.find_neighbors("neighbors", c.support, fluid, w.akinci2012, w.monaghan2009);
    if (fluid.kind.data) backend.share("kind", fluid, fluid.kind);
    if (!w.bodies) return;
    backend.list_neighbors("bodies", c.support, w.of_bodies, fluid);
    show_bodies(backend, fluid, w);
  }

  void density_and_factor(B& backend, const Fluid& fluid, const Walls<D>& w,
                          const char* name = "density, factor") const {
    const auto f = fluid;
    const Real least = Real(1e-3f) * c.response;
    const Liquids liquids = c.liquids;
    backend.sum_pairs(name, f, over(f, FluidDensityAndResponse{W, c.m, c.m_density, c.liquids, f}),
                      over(w.akinci2012, Akinci2012DensityAndResponse{W, w.akinci2012.psi}),
                      [=] FRESHET_LAMBDA(int i, const DensityAndResponse<D, Real>& sum) {
                        const Real response = sum.response(liquids.lightness(f, i));
                        f.rho[i] = sum.rho;
                        f.factor[i] = response > least ? 1 / response : 0;
                      });
    backend.share("rho", f, f.rho);
  }

  /// a by viscosity, g, walls that repel and what else acts, and v + dt a.
  void push_without_pressure(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt,
                             Vec<D> g) const {
    const auto f = fluid;
    const Liquids liquids = c.liquids;
    backend.share("v", f, f.v);
    rub_bodies(backend, f, w);  // first: what follows changes v
    backend.sum_pairs("viscosity", f, over(f, fluid_friction(f, c.xsph / dt)),
                      over(w.akinci2012, akinci2012_friction(f, w.akinci2012)),
                      over(w.monaghan2009, monaghan2009_forces(f, w)),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) {
                        f.a[i] = liquids.lightness(f, i) * sum + g;
                        f.v[i] += dt * f.a[i];
                      });
    backend.share("v", f, f.v);
    if (w.bodies) push_bodies(backend, f, w, dt);
    if (forces) forces->push(backend, f, w, dt);
  }

  /// finish(i, Drho_i/Dt) by the velocities v; by accelerations, its own rate.
  template <class Finish>
  void density_rate(B& backend, const Fluid& f, const Walls<D>& w, Field<Vec<D>> v,
                    const Finish& finish) const {
    const auto of_bodies = w.rate;
    backend.sum_pairs("solve: rate", f, over(f, DensityRate{W, c.m, v}),
                      over(w.akinci2012, Akinci2012DensityRate{W, w.akinci2012.psi, v}),
                      [=] FRESHET_LAMBDA(int i, Real rate) {
                        finish(i, of_bodies.data ? rate - of_bodies[i] : rate);
                      });
  }
  /// finish(i, acceleration) by the pressures k = p/rho^2.
  template <class Finish>
  void pressure_acceleration(B& backend, const Fluid& f, const Walls<D>& w, Field<Real> k,
                             const Finish& finish) const {
    backend.share("k", f, k);
    backend.sum_pairs("solve: push", f, over(f, PressureAcceleration{W, c.m, k}),
                      over(w.akinci2012, Akinci2012PressureAcceleration{W, k, w.akinci2012.psi}),
                      Lightened<Finish>{f, c.liquids, finish});
  }
  template <class Finish> struct Lightened {
    Fluid f;
    Liquids liquids;
    Finish finish;
    FRESHET_HD void operator()(int i, Vec<D> sum) const {
      finish(i, liquids.lightness(f, i) * sum);
    }
  };

  // Bodies answer to every push of a solve, as if nothing but their hinge held them: a light one
  // moves aside, and the pressures are what that takes. Who moves them at last is the engine.
  using Coupling = BodyCoupling<D>;
  using Body = typename Coupling::Body;

  /// The fluid sees how they move.
  void show_bodies(B& backend, const Fluid& f, const Walls<D>& w) const {
    show_bodies(backend, f, w, [](const Body& b) { return b.motion; });
  }
  template <class Motion>
  void show_bodies(B& backend, const Fluid& f, const Walls<D>& w, const Motion& motion) const {
    Coupling::set_velocities(backend, w, motion);
    Coupling::set_rate(backend, w, f, W);
  }
  /// What pressures k do to them: body.push [m/s^2] is how they answer.
  void press_bodies(B& backend, const Fluid& f, const Walls<D>& w, Field<Real> k) const {
    backend.share("k", f, k);
    Coupling::sum_reactions(backend, w, f, akinci2012_forces(k, w.of_bodies));
    for (std::size_t b = 0; b < w.bodies->all.size(); ++b)
      w.bodies->all[b].push = w.bodies->all[b].answer(w.bodies->totals[b]);
  }
  /// The impulse of pressures k over dt.
  void note_impulse(B& backend, const Fluid& f, const Walls<D>& w, Field<Real> k, Real dt) const {
    if (!w.bodies) return;
    backend.share("k", f, k);
    Coupling::sum_reactions(backend, w, f, akinci2012_forces(k, w.of_bodies));
    note_impulse(w, double(dt));
  }
  void note_impulse(const Walls<D>& w, double dt) const {
    for (std::size_t b = 0; b < w.bodies->all.size(); ++b)
      w.bodies->all[b].impulse += dt * w.bodies->totals[b];
  }
  /// What friction does to them, in totals.
  void rub_bodies(B& backend, const Fluid& f, const Walls<D>& w) const {
    if (w.bodies) Coupling::sum_reactions(backend, w, f, akinci2012_friction(f, w.of_bodies));
  }
  /// Friction and what pulls at them change their motion.
  void push_bodies(B& backend, const Fluid& f, const Walls<D>& w, Real dt) const {
    note_impulse(w, double(dt));
    if (!w.bodies->respond) return;
    for (std::size_t b = 0; b < w.bodies->all.size(); ++b) {
      Body& body = w.bodies->all[b];
      body.motion += double(dt) * (body.answer(w.bodies->totals[b]) + body.pull);
    }
    show_bodies(backend, f, w);
  }

  /// What is left to remove, as a mean over the fluid and a share of the rest density: what is too
  /// dense, or what pressures hold too far apart, whichever is more.
  double error(B& backend, const Fluid& f) const {
    if (f.n == 0) return 0;
    const auto excess = f.excess;
    const double net =
        backend.sum("solve: error", f, [=] FRESHET_LAMBDA(int i) { return excess[i]; });
    const double all = backend.sum("solve: error", f, [=] FRESHET_LAMBDA(int i) {
      return excess[i] < 0 ? -excess[i] : excess[i];
    });
    return (all + std::abs(net)) / (2 * double(f.n) * double(c.rho0));
  }

  /// The part of an excess that is still to be removed, where k_per_excess · excess is the k that
  /// would: a pressure of zero cannot fall, and where nothing answers there is nothing to do.
  FRESHET_HD static Real left_of(Real excess, Real k, Real k_per_excess) {
    return k_per_excess > 0 ? max(excess, -k / k_per_excess) : 0;
  }

  /// v as the solve left it, x after it.
  void drift(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    const auto confine = c.confine;
    backend.for_each("drift", f, [=] FRESHET_LAMBDA(int i) {
      f.p[i] = f.k[i] * square(f.rho[i]);
      f.x[i] += dt * f.v[i];
      confine(i, f.x[i], f.v[i]);
    });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// What the solvers share that solve for the pressure, so that the density stays what it is.
#pragma once
#include <array>
#include <cmath>
#include <utility>

#include "boundary/confinement.h"
#include "freshet/time_step.h"
#include "pairs/density_and_response.h"
#include "pairs/density_rate.h"
#include "pairs/laminar_viscosity.h"
#include "pairs/monaghan2009.h"
#include "pairs/pressure_acceleration.h"
#include "solvers/integrators.h"
#include "solvers/solve.h"
#include "solvers/time_step.h"
#include "solvers/wall_samples.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct IncompressibleParameters {
  Real support, h;    ///< support radius, half of it [m]
  Real m, m_density;  ///< mass [kg]; mass over the kernel's lattice sum [kg]
  Real rho0;          ///< rest density [kg/m^D]
  Real nu, xsph;      ///< kinematic viscosity [m^2/s]; XSPH's share a step
  Real repulsion;     ///< K of the repulsive walls [m^2/s^2]
  Real response;      ///< of a particle in a resting lattice (pairs/density_and_response.h)
  Real stiffness;     ///< the equations' greatest eigenvalue over their diagonal, there
  Vec<D> gravity;     ///< [m/s^2]
  Confinement<D> confine;
  bool warm_start, accelerated;
  Iterations density, divergence;

  Real eps_h2() const { return Real(0.01f) * h * h; }
  /// How long a step of Jacobi's may be: as the paper has it, but with room below the longest that
  /// converges, 2/stiffness.
  Real relaxation(Real papers) const { return min(papers, Real(1.6f) / stiffness); }
};

template <int D> struct IncompressibleFluid : Particles<D> {
  Field<Real> k;       ///< kept: p/rho^2
  Field<Vec<D>> a;     ///< acceleration over the step
  Field<Real> rho, p;  ///< scratch: density [kg/m^D], pressure [Pa]
  Field<Real> factor;  ///< scratch: 1/response, 0 where nothing answers
  Field<Real> excess;  ///< scratch: what a solve has to remove [kg/m^D]
  template <class Visit> void fields(Visit visit) {
    visit("k", Keep::kept, k);
    visit("a", Keep::scratch, a);
    visit("rho", Keep::scratch, rho);
    visit("p", Keep::scratch, p);
    visit("factor", Keep::scratch, factor);
    visit("excess", Keep::scratch, excess);
  }
};

template <int D, Backend<D> B, template <int> class Kernel, class FluidT> struct Incompressible {
  using Fluid = FluidT;
  IncompressibleParameters<D> c;
  Kernel<D> W;

  template <class Visit> void fields(Fluid& f, Visit visit) const { f.fields(visit); }
  void prepare(B& backend, Walls<D>& walls) const { prepare_walls(backend, walls, W, c); }

  /// Without sound, what is left of its bound is the flow's: none may cross 0.4 h in a step.
  TimeStepBounds bounds(B& backend, const Fluid& f) const {
    TimeStepBounds b = time_step_bounds(backend, f, double(c.h), 0, double(c.nu));
    std::swap(b.acoustic, b.flow);
    return b;
  }

  /// The pair terms of the forces, for what else asks who pushes whom.
  auto fluid_forces(const Fluid& f) const { return PressureAcceleration{W, c.m, f.k}; }
  auto fluid_friction(const Fluid& f, Real xsph_rate = 0) const {
    return LaminarViscosity{W, c.m, c.nu, c.eps_h2(), xsph_rate, f.rho, f.v};
  }
  auto akinci2012_forces(const Fluid& f, const Walls<D>& w) const {
    return Akinci2012PressureAcceleration{W, f.k, w.akinci2012.psi};
  }
  auto akinci2012_friction(const Fluid& f, const Walls<D>& w) const {
    return Akinci2012Friction{
        W, c.nu, c.eps_h2(), f.rho, f.v, w.akinci2012.psi, w.akinci2012.friction};
  }
  auto monaghan2009_forces(const Fluid&, const Walls<D>&) const {
    return Monaghan2009Repulsion<D>{c.repulsion, c.h};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  void find_neighbors(B& backend, Fluid& fluid, const Walls<D>& w) const {
    backend.find_neighbors("neighbors", c.support, fluid, w.akinci2012, w.monaghan2009);
  }

  void density_and_factor(B& backend, const Fluid& fluid, const Walls<D>& w,
                          const char* name = "density, factor") const {
    const auto f = fluid;
    const Real least = Real(1e-3f) * c.response;
    backend.sum_pairs(name, f, over(f, FluidDensityAndResponse{W, c.m, c.m_density}),
                      over(w.akinci2012, Akinci2012DensityAndResponse{W, w.akinci2012.psi}),
                      [=] FRESHET_LAMBDA(int i, const DensityAndResponse<D, Real>& sum) {
                        const Real response = sum.response();
                        f.rho[i] = sum.rho;
                        f.factor[i] = response > least ? 1 / response : 0;
                      });
    backend.share("rho", f, f.rho);
  }

  /// a by viscosity, g and walls that repel, and v + dt a.
  void push_without_pressure(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt,
                             Vec<D> g) const {
    const auto f = fluid;
    backend.share("v", f, f.v);
    backend.sum_pairs("viscosity", f, over(f, fluid_friction(f, c.xsph / dt)),
                      over(w.akinci2012, akinci2012_friction(f, w)),
                      over(w.monaghan2009, monaghan2009_forces(f, w)),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) {
                        f.a[i] = sum + g;
                        f.v[i] += dt * f.a[i];
                      });
    backend.share("v", f, f.v);
  }

  /// finish(i, Drho_i/Dt) by the velocities v; by accelerations, its own rate.
  template <class Finish>
  void density_rate(B& backend, const Fluid& f, const Walls<D>& w, Field<Vec<D>> v,
                    const Finish& finish) const {
    backend.sum_pairs("solve: rate", f, over(f, DensityRate{W, c.m, v}),
                      over(w.akinci2012, Akinci2012DensityRate{W, w.akinci2012.psi, v}), finish);
  }
  /// finish(i, acceleration) by the pressures k = p/rho^2.
  template <class Finish>
  void pressure_acceleration(B& backend, const Fluid& f, const Walls<D>& w, Field<Real> k,
                             const Finish& finish) const {
    backend.share("k", f, k);
    backend.sum_pairs("solve: push", f, over(f, PressureAcceleration{W, c.m, k}),
                      over(w.akinci2012, Akinci2012PressureAcceleration{W, k, w.akinci2012.psi}),
                      finish);
  }

  /// What is left to remove, as a mean over the fluid and a share of the rest density: what is too
  /// dense, or what pressures hold too far apart, whichever is more.
  double error(B& backend, const Fluid& f) const {
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

// SPDX-License-Identifier: MIT
/// The parts that the pressure solvers share. Functions that do not depend on the solver are
/// defined in incompressible_impl.h and compiled once per backend, dimension and kernel.
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

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct IncompressibleParameters {
  Real support, h;    ///< support radius, half of it [m]
  Real m, m_density;  ///< mass [kg/m^(3-D)]; mass over the kernel's lattice sum [kg/m^(3-D)]
  Real rho0;          ///< rest density [kg/m^3]
  Liquids liquids;
  Real most_nu;          ///< maximum kinematic viscosity [m^2/s]
  Real xsph, xsph_time;  ///< share of XSPH, and the time in which [s]; 0: ten steps
  Real repulsion;        ///< K of the repulsive walls [m^2/s^2]
  Real response;         ///< of a particle in a resting lattice (pairs/density_and_response.h)
  Real stiffness;        ///< largest eigenvalue of the equations over their diagonal, in a lattice
  Vec<D> gravity;        ///< [m/s^2]
  Confinement<D> confine;
  Real deficit;  ///< rho0 times that of a flat surface (kernels/lattice_sum.h) [kg/m^3]
  bool warm_start, accelerated;
  bool gradual;  ///< errors of the density are removed in many steps
  Iterations density, divergence;
  Iterations divergence_at_rest;  ///< for `gradual`, in water almost at rest (solvers/dfsph.h)

  /// The density that the pressures of a step should remove, beside dt Drho/Dt [kg/m^3], for a
  /// density and the sum of m grad W. If it is all of rho - rho0, as in the papers, the push that
  /// corrects positions stays as motion: still water warms, and waves lose their height. `gradual`
  /// removes a fifth [after Baumgarte 1972] of what is outside of 0.99 to 1.001 rho0, so that the
  /// velocity is nearly divergence-free, and voids close. At a free surface neighbours lack on one
  /// side, and the sum of gradients tells how much lacks. It is counted twice, since surfaces are
  /// uneven: taken for dilution, it would make the surface sink into the fluid.
  FRESHET_HD Real to_remove(Real rho, Vec<D> gradient) const {
    if (!gradual) return rho - rho0;
    const Real filled = rho + 2 * deficit * (norm2(gradient) / response);
    return Real(0.2f) *
           (max(rho - Real(1.001f) * rho0, Real(0)) + min(filled - Real(0.99f) * rho0, Real(0)));
  }

  Real eps_h2() const { return Real(0.01f) * h * h; }
  /// XSPH's share per time [1/s].
  Real xsph_rate(Real dt) const {
    return xsph / (xsph_time > 0 ? max(dt, xsph_time) : Real(10) * dt);
  }
  /// The relaxation factor of a Jacobi iteration: the paper's, but at most 1.6/stiffness. The
  /// iteration converges below 2/stiffness.
  Real relaxation(Real papers) const { return min(papers, Real(1.6f) / stiffness); }
};

template <int D> struct IncompressibleFluid : FluidParticles<D> {
  Field<Real> k;          ///< kept: p/rho^2 [Pa m^6/kg^2]
  Field<Real> factor;     ///< scratch: 1/response [m^8/kg^2], 0 for a negligible response
  Field<Real> to_remove;  ///< scratch: density that a step removes beside dt Drho/Dt [kg/m^3]
  Field<Real> excess;     ///< scratch: excess density that a solve still has to remove [kg/m^3]
  template <class Visit> void fields(Visit visit) {
    visit("k", Keep::kept, k);
    visit("a", Keep::scratch, this->a);
    visit("rho", Keep::scratch, this->rho);
    visit("p", Keep::scratch, this->p);
    visit("factor", Keep::scratch, factor);
    visit("to_remove", Keep::scratch, to_remove);
    visit("excess", Keep::scratch, excess);
  }
};

template <int D, Backend<D> B, template <int> class Kernel> struct Incompressible {
  using BaseFluid = IncompressibleFluid<D>;
  IncompressibleParameters<D> c;
  Kernel<D> W;
  NonPressureForces<D, B>* forces = nullptr;  ///< forces beside pressure; null: none

  template <class Fluid, class Visit> void fields(Fluid& f, Visit visit) const { f.fields(visit); }

  TimeStepBounds bounds(B& backend, const BaseFluid& f) const;

  /// The pair terms of the forces, also for sums of the forces on walls.
  auto fluid_forces(const BaseFluid& f) const { return PressureAcceleration{W, c.m, f.k}; }
  auto fluid_friction(const BaseFluid& f, Real xsph_rate = 0) const {
    return LaminarViscosity{W, c.m, c.liquids, c.eps_h2(), xsph_rate, f};
  }
  auto akinci2012_forces(const BaseFluid& f, const AkinciWall<D>& w) const {
    return akinci2012_forces(f.k, w);
  }
  auto akinci2012_forces(Field<Real> k, const AkinciWall<D>& w) const {
    return Akinci2012PressureAcceleration{W, k, w.psi};
  }
  auto akinci2012_friction(const BaseFluid& f, const AkinciWall<D>& w) const {
    return Akinci2012Friction{W, c.liquids, c.eps_h2(), f, w.psi, w.friction, w.v};
  }
  auto monaghan2009_forces(const BaseFluid&, const Walls<D>&) const {
    return Monaghan2009Repulsion<D>{c.repulsion, c.h};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  void find_neighbors(B& backend, BaseFluid& fluid, const Walls<D>& w) const;
  void density_and_factor(B& backend, const BaseFluid& fluid, const Walls<D>& w,
                          const char* name = "density, factor") const;
  /// Sets a by viscosity, g, repulsive walls and other forces, and adds dt a to v.
  void push_without_pressure(B& backend, const BaseFluid& fluid, const Walls<D>& w, Real dt,
                             Vec<D> g) const;

  /// Updates v at copies for density_rate: ghosts slide with the fluid, also at no-slip sides. If
  /// they moved against it, a flow along a side would change the density.
  void share_for_rate(B& backend, const BaseFluid& f) const {
    Particles<D> sliding = f;
    sliding.v = {};
    backend.share("v", sliding, f.v);
  }
  /// Calls finish(i, Drho_i/Dt) for the velocities v. For accelerations in place of v it is the
  /// rate of Drho_i/Dt.
  template <class Finish>
  void density_rate(B& backend, const BaseFluid& f, const Walls<D>& w, Field<Vec<D>> v,
                    const Finish& finish) const {
    const auto of_bodies = w.rate;
    backend.sum_pairs("solve: rate", f, over(f, DensityRate{W, c.m, v}),
                      over(w.akinci2012, Akinci2012DensityRate{W, w.akinci2012.psi, v}),
                      [=] FRESHET_LAMBDA(int i, Real rate) {
                        finish(i, of_bodies.data ? rate - of_bodies[i] : rate);
                      });
  }
  /// Calls finish(i, acceleration) for the pressures k = p/rho^2.
  template <class Finish>
  void pressure_acceleration(B& backend, const BaseFluid& f, const Walls<D>& w, Field<Real> k,
                             const Finish& finish) const {
    backend.share("k", f, k);
    backend.sum_pairs("solve: push", f, over(f, PressureAcceleration{W, c.m, k}),
                      over(w.akinci2012, Akinci2012PressureAcceleration{W, k, w.akinci2012.psi}),
                      Lightened<Finish>{f, c.liquids, finish});
  }
  template <class Finish> struct Lightened {
    BaseFluid f;
    Liquids liquids;
    Finish finish;
    FRESHET_HD void operator()(int i, Vec<D> sum) const {
      finish(i, liquids.lightness(f, i) * sum);
    }
  };

  // During a solve bodies respond to the pressures; of their constraints only hinges count. The
  // pressures thus account for a light body that moves aside. The engine moves the bodies after the
  // step.
  using Coupling = BodyCoupling<D>;
  using Body = typename Coupling::Body;
  using Twist = typename Coupling::Twist;

  /// Sets the velocities of body particles and the density rate by them, from the bodies' motion.
  void show_bodies(B& backend, const BaseFluid& f, const Walls<D>& w) const {
    show_bodies(backend, f, w, [](const Body& b) { return b.motion; });
  }
  /// Sets the velocities of body particles and the density rate by them, from motion(body).
  template <class Motion>
  void show_bodies(B& backend, const BaseFluid& f, const Walls<D>& w, const Motion& motion) const {
    Coupling::set_velocities(backend, w, motion);
    set_rate(backend, f, w);
  }
  /// Sets body.push to the acceleration by the pressures k [m/s^2, rad/s^2].
  void press_bodies(B& backend, const BaseFluid& f, const Walls<D>& w, Field<Real> k) const;
  /// Adds the impulse of the pressures k over dt to each body [N s, N m s; per m in 2D].
  void note_impulse(B& backend, const BaseFluid& f, const Walls<D>& w, Field<Real> k,
                    Real dt) const;
  void note_impulse(const Walls<D>& w, double dt) const {
    for (std::size_t b = 0; b < w.bodies->all.size(); ++b)
      w.bodies->all[b].impulse += dt * w.bodies->totals[b];
  }
  void set_rate(B& backend, const BaseFluid& f, const Walls<D>& w) const;
  /// Sums the friction on bodies into `totals` [N, N m; per m in 2D].
  void rub_bodies(B& backend, const BaseFluid& f, const Walls<D>& w) const;
  /// Changes the motion of bodies by friction (in `totals`) and by their loads (`pull`).
  void push_bodies(B& backend, const BaseFluid& f, const Walls<D>& w, Real dt) const;

  /// The error of a solve: the mean of |excess| with one sign over the rest density, for the sign
  /// where it is larger. Positive excess is compression; negative excess is separation by pressures
  /// that are too large.
  double error(B& backend, const BaseFluid& f) const;

  /// The part of an excess that a change of pressure can still remove [kg/m^3]. k_per_excess ·
  /// excess is the change of k that would remove it. k cannot fall below zero. It is 0 where
  /// k_per_excess is 0.
  FRESHET_HD static Real left_of(Real excess, Real k, Real k_per_excess) {
    return k_per_excess > 0 ? max(excess, -k / k_per_excess) : 0;
  }

  /// Advances x by dt v, sets v to v_after, confines the particles, and sets p from k.
  void drift(B& backend, const BaseFluid& fluid, Real dt, Field<Vec<D>> v_after) const;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// What the weakly compressible solvers share: numbers, the equation of state, Adami's walls.
#pragma once
#include <utility>

#include "boundary/confinement.h"
#include "core/fluid_particles.h"
#include "freshet/time_step.h"
#include "pairs/adami2012.h"
#include "pairs/monaghan2009.h"
#include "solvers/body_coupling.h"
#include "solvers/integrators.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct WeaklyCompressibleParameters {
  Real support, h;    ///< support radius, half of it [m]
  Real m, m_density;  ///< mass [kg]; mass over the kernel's lattice sum [kg]
  Real rho0, c0;      ///< of the densest liquid: rest density [kg/m^D], speed of sound [m/s]
  Real background;    ///< pressure at rest density [Pa]
  Real alpha, delta;  ///< of artificial viscosity and of density diffusion
  Liquids liquids;
  Real lightest;   ///< the greatest lightness
  Vec<D> gravity;  ///< [m/s^2]
  Confinement<D> confine;
  Integrator integrator;
  bool antuono;  ///< of delta_sph: diffusion of Antuono 2010, else of Fourtakas 2019

  Real eps_h2() const { return Real(0.01f) * h * h; }
  /// B in p = B((rho/rho0)^7 - 1), so that sound has c0: B = rho0 c0^2/7
  Real B() const { return rho0 * c0 * c0 / 7; }
  /// What sound and its viscosity are in the lightest liquid, of as much bulk modulus.
  double fastest_sound() const { return double(c0) * std::sqrt(double(lightest)); }
  double artificial_nu() const {
    return double(alpha) * double(h) * double(c0) / (2 * (D + 2)) * double(lightest);
  }
  /// K of the repulsive walls: (0.1 c0)^2, as c0 is ten times the fastest flow sqrt(2 g depth)
  Real repulsion() const { return square(Real(0.1f) * c0); }
};

/// p = B((rho/rho0)^7 - 1) + background  [Becker and Teschner 2007, eq. 7]
FRESHET_HD Real tait(Real B, Real rho_over_rho0, Real background) {
  const Real q = rho_over_rho0, q2 = q * q;
  return B * (q2 * q2 * q2 * q - 1) + background;
}

/// One step: rates() fills a by pressure, walls and gravity; `forces` adds what else acts, if
/// anything does. Leapfrog needs the velocity's rate before it knows the step's: there the implicit
/// part of them has a step of its own, after the other one [Lie's splitting].
template <int D, class B, class Fluid, class Rates>
void integrate_with(B& backend, const WeaklyCompressibleParameters<D>& c, const Fluid& f,
                    const Walls<D>& w, const Tick& t, NonPressureForces<D, B>* forces,
                    const Rates& rates) {
  const bool leapfrog = c.integrator == Integrator::leapfrog;
  const auto from = c.integrator == Integrator::symplectic_euler ? f.v
                    : leapfrog                                   ? Field<Vec<D>>{}
                                                                 : f.v_memory;
  bool starts = leapfrog && t.step == 0;  // with rates that are no step's
  integrate(backend, c.integrator, f, c.confine, t, [&] {
    rates();
    if (forces) forces->accelerate(backend, f, w, std::exchange(starts, false) ? 0 : t.dt, from);
  });
  if (forces && leapfrog) forces->relax(backend, f, w, t.dt);
}

/// After the search: bodies show how they move.
template <int D, class B, class Fluid>
void show_bodies(B& backend, const Walls<D>& w, const Fluid& f, Real support) {
  if (!w.bodies) return;
  if (w.of_layered_bodies.n > 0) {
    backend.list_neighbors("bodies", support, w.of_layered_bodies, f);
    BodyCoupling<D>::show_motion(backend, w);
  } else {
    backend.list_neighbors("bodies", support, w.of_bodies, f);
    BodyCoupling<D>::set_velocities(backend, w, [](const auto& body) { return body.motion; });
  }
}

/// p and v of wall particles of Adami whose neighbours have been listed. A wall pushes and never
/// pulls.
template <int D, class B, class Kernel, class Fluid>
void extrapolate(B& backend, const char* name, const AdamiWall<D>& wall, const Fluid& f,
                 const Kernel& W, const WeaklyCompressibleParameters<D>& c) {
  const auto p = wall.p;
  const auto v = wall.v;
  const auto slide = wall.slide;
  const auto u = wall.u;
  backend.sum_pairs(name, wall, over(f, Adami2012Extrapolation{W, c.gravity, c.liquids, f, wall.a}),
                    [=] FRESHET_LAMBDA(int w, const Adami2012Sums<D, Real>& sum) {
                      const bool wet = sum.W > Real(1e-37f);  // 1/W is finite
                      p[w] = wet ? max((sum.p + sum.rho_x) / sum.W, Real(0)) : 0;
                      v[w] = wet ? 2 * (slide[w] + u[w]) - Real(1) / sum.W * sum.v : Vec<D>{};
                    });
}

/// Of all of them, and of the bodies' once more.
template <int D, class B, class Kernel, class Fluid>
void extrapolate_to_walls(B& backend, const Walls<D>& w, const Fluid& f, const Kernel& W,
                          const WeaklyCompressibleParameters<D>& c) {
  if (w.adami2012.n == 0) return;
  AdamiWall<D> wall = w.adami2012;
  wall.moves = false;  // since it was found
  backend.list_neighbors("walls", c.support, wall, f);
  extrapolate(backend, "walls", wall, f, W, c);
  if (w.of_layered_bodies.n > 0) extrapolate(backend, "bodies", w.of_layered_bodies, f, W, c);
}

}  // namespace FRESHET_ISA
}  // namespace freshet

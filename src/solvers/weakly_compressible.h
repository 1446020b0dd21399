// SPDX-License-Identifier: MIT
/// The parts that the weakly compressible solvers share: parameters, the equation of state, Adami's
/// walls.
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
  Real support, h;        ///< support radius, half of it [m]
  Real m, m_density;      ///< mass [kg/m^(3-D)]; mass over the kernel's lattice sum [kg/m^(3-D)]
  Real rho0, c0;          ///< rest density [kg/m^3] and speed of sound [m/s] of the densest liquid
  Real background;        ///< pressure at rest density [Pa]
  Real alpha, delta;      ///< coefficients of artificial viscosity and of density diffusion
  Real acoustic_damping;  ///< delta_sph: coefficient of the bulk viscosity
  Liquids liquids;
  Real lightest;   ///< the maximum lightness
  Vec<D> gravity;  ///< [m/s^2]
  Confinement<D> confine;
  Integrator integrator;
  bool antuono;  ///< delta_sph: diffusion of Antuono 2010, else of Fourtakas 2019

  Real eps_h2() const { return Real(0.01f) * h * h; }
  /// B of p = B((rho/rho0)^7 - 1) for the speed of sound c0: B = rho0 c0^2/7 [Pa]
  Real B() const { return rho0 * c0 * c0 / 7; }
  /// Speed of sound [m/s] and artificial viscosity [m^2/s] in the lightest liquid; all liquids have
  /// the same bulk modulus.
  double fastest_sound() const { return double(c0) * std::sqrt(double(lightest)); }
  double artificial_nu() const {
    return double(alpha) * double(h) * double(c0) / (2 * (D + 2)) * double(lightest);
  }
  /// K of the repulsive walls [m^2/s^2]: (0.1 c0)^2, because c0 is ten times sqrt(2 g depth), the
  /// speed of the fastest flow.
  Real repulsion() const { return square(Real(0.1f) * c0); }
};

/// p = B((rho/rho0)^7 - 1) + background  [Becker and Teschner 2007, eq. 7]
FRESHET_HD Real tait(Real B, Real rho_over_rho0, Real background) {
  const Real q = rho_over_rho0, q2 = q * q;
  return B * (q2 * q2 * q2 * q - 1) + background;
}

/// Takes one step. rates() computes a by pressure, walls and gravity; `forces` adds the other
/// forces. Leapfrog needs the acceleration of the previous step at the start of the next one. It
/// therefore takes the implicit part of `forces` as a separate step after the explicit one [Lie
/// splitting].
template <int D, class B, class Fluid, class Rates>
void integrate_with(B& backend, const WeaklyCompressibleParameters<D>& c, const Fluid& f,
                    const Walls<D>& w, const Tick& t, NonPressureForces<D, B>* forces,
                    const Rates& rates) {
  const bool leapfrog = c.integrator == Integrator::leapfrog;
  const auto from = c.integrator == Integrator::symplectic_euler ? f.v
                    : leapfrog                                   ? Field<Vec<D>>{}
                                                                 : f.v_memory;
  bool starts = leapfrog && t.step == 0;  // the first rates() is at time 0, without a step
  integrate(backend, c.integrator, f, c.confine, t, [&] {
    rates();
    if (forces) forces->accelerate(backend, f, w, std::exchange(starts, false) ? 0 : t.dt, from);
  });
  if (forces && leapfrog) forces->relax(backend, f, w, t.dt);
}

/// Call after the neighbour search. It lists the fluid neighbours of body particles and sets their
/// velocities from the bodies' motion.
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

/// Extrapolates p and v to wall particles of Adami 2012 whose neighbours have been listed. Negative
/// pressures are set to zero: a wall pushes and never pulls.
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

/// Extrapolates p and v to all wall particles of adami2012, and to the second set of body
/// particles.
template <int D, class B, class Kernel, class Fluid>
void extrapolate_to_walls(B& backend, const Walls<D>& w, const Fluid& f, const Kernel& W,
                          const WeaklyCompressibleParameters<D>& c) {
  if (w.adami2012.n == 0) return;
  AdamiWall<D> wall = w.adami2012;
  wall.moves = false;  // find_neighbors has sorted it in this step
  backend.list_neighbors("walls", c.support, wall, f);
  extrapolate(backend, "walls", wall, f, W, c);
  if (w.of_layered_bodies.n > 0) extrapolate(backend, "bodies", w.of_layered_bodies, f, W, c);
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "freshet/methods.h"
#include "freshet/time_step.h"
#include "solvers/backend.h"
#include "solvers/non_pressure_forces.h"
#include "solvers/solve.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The air: its density [kg/m^3], dynamic viscosity [Pa s] and velocity [m/s].
template <int D> struct Air {
  Real rho, mu;
  Vec<D> wind;
};

/// Which forces act, and their numbers.
template <int D> struct ForceParameters {
  ViscosityMethod viscosity;  ///< artificial: none of these, the solver's own
  SurfaceTensionMethod tension;
  ShiftingMethod shifting;
  VorticityMethod vorticity;
  Drag drag;

  Real support, h;  ///< support radius, half of it [m]
  Real spacing;     ///< [m]
  Real m, rho0;     ///< mass [kg/m^(3-D)], rest density [kg/m^3] of the densest liquid
  Liquids liquids;
  Real nu_t, Theta;     ///< of Bender 2017 [m^2/s, m^2]
  Iterations implicit;  ///< of Weiler 2018
  Air<D> air;
  Real c0;                ///< speed of sound; 0 for a solver without sound [m/s]
  Real W_spacing;         ///< W at the distance of one spacing [1/m^D]
  Real neighbors_inside;  ///< in a resting lattice
  Real depth;             ///< mean of |x| in W [m]
  bool no_walls;          ///< nothing holds the fluid
  /// The papers' 0.01 h^2 makes a liquid 1.5 % thinner, however fine the particles are.
  Real eps_h2() const { return Real(1e-4f) * h * h; }
};

/// One force beside pressure, gravity and walls, or one shift of the particles. Each is a class in
/// a file that has its paper's name, with a line in the list of forces.h. When it is called,
/// neighbours have been found, rho is known and v is shared with copies.
template <int D, class B> struct Force {
  using Fluid = FluidParticles<D>;
  virtual ~Force() = default;
  virtual void fields(FieldMaker<D>&) {}
  /// push += the acceleration by it [m/s^2], in a step of dt.
  virtual void add(B&, const Fluid&, const Walls<D>&, Real /*dt*/, Field<Vec<D>> /*push*/) {}
  /// Whether it solves for the velocity at the end of the step instead.
  virtual bool is_implicit() const { return false; }
  /// v after dt; returns the solve result.
  virtual Solve relax(B&, const Fluid&, const Walls<D>&, Real /*dt*/, Field<Vec<D>> /*v*/) {
    return {};
  }
  /// Moves particles at the end of a step of dt.
  virtual void move(B&, const Fluid&, Real /*dt*/) const {}
  /// Lowers the time-step bounds.
  virtual void bound(TimeStepBounds&) const {}
  /// Adds the reactions on walls.
  virtual void add_wall_forces(const Fluid&, const Walls<D>&, WallForces<D, B>&) const {}
};

/// push += lightness sum: the end of a pass over pairs.
template <int D> struct AddTo {
  Field<Vec<D>> push;
  PerLiquid lightness;
  FRESHET_HD void operator()(int i, Vec<D> sum) const { push[i] += lightness[i] * sum; }
};

/// dt <= h^2/(8 nu), for the thickest liquid [Morris, Fox, Zhu 1997].
template <int D> void bound_by_viscosity(const ForceParameters<D>& c, TimeStepBounds& bounds) {
  const double h = double(c.h);
  for (int k = 0; k < c.liquids.count; ++k) {
    const Liquid& liquid = c.liquids[k];
    const double rho = double(c.rho0) / double(liquid.lightness), mu = double(liquid.mu);
    if (mu > 0) bounds.viscous = std::min(bounds.viscous, 0.125 * h * h * rho / mu);
  }
}

/// dt <= sqrt(rho h^3/(2 pi sigma))/4: the shortest capillary wave [Morris 2000].
template <int D> void bound_by_tension(const ForceParameters<D>& c, TimeStepBounds& bounds) {
  const double h = double(c.h);
  for (int k = 0; k < c.liquids.count; ++k) {
    const Liquid& liquid = c.liquids[k];
    const double rho = double(c.rho0) / double(liquid.lightness), sigma = double(liquid.sigma);
    if (sigma > 0)
      bounds.capillary =
          std::min(bounds.capillary, 0.25 * std::sqrt(rho * h * h * h / (2 * double(pi) * sigma)));
  }
}

}  // namespace FRESHET_ISA
}  // namespace freshet

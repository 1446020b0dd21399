// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "freshet/time_step.h"
#include "solvers/solve.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class B> class WallForces;

/// Allots the memory of a fluid's field.
template <int D> struct FieldMaker {
  virtual ~FieldMaker() = default;
  virtual void make(const char* name, Keep keep, Field<Real>& field) = 0;
  virtual void make(const char* name, Keep keep, Field<Vec<D>>& field) = 0;
  virtual void make(const char* name, Keep keep, Field<int>& field) = 0;
};

/// What acts on a fluid beside pressure, gravity and walls: viscosity, surface tension, vorticity,
/// air, and what shifts its particles. A solver calls it through a pointer, null where there is
/// nothing of the kind; so that each method is compiled once for a backend, and not into every
/// solver. Neighbours have been found and rho is known whenever a solver calls; copies know rho.
template <int D, class B> struct NonPressureForces {
  using Fluid = FluidParticles<D>;
  virtual ~NonPressureForces() = default;
  virtual void fields(FieldMaker<D>& maker) = 0;

  /// a += what acts, of a solver that integrates accelerations. What is solved for implicitly
  /// starts from the velocity `from` + dt a, and becomes an acceleration over dt; no memory: it
  /// waits for `relax`. dt = 0: nothing is advanced in time.
  virtual void accelerate(B& backend, const Fluid& f, const Walls<D>& w, Real dt,
                          Field<Vec<D>> from) = 0;
  /// v by what is solved for implicitly, over a step of dt: after a step.
  virtual void relax(B& backend, const Fluid& f, const Walls<D>& w, Real dt) = 0;
  /// a += what acts, and v += dt times it: of a solver that predicts velocities.
  virtual void push(B& backend, const Fluid& f, const Walls<D>& w, Real dt) = 0;
  /// Shifts particles, at the end of a step of dt.
  virtual void shift(B& backend, const Fluid& f, Real dt) const = 0;

  /// Makes the bounds of a step smaller where these forces ask for it.
  virtual void bound(TimeStepBounds& bounds) const = 0;
  /// What the last step's implicit solve came to; none where nothing is solved.
  virtual std::optional<Solve> solve() const = 0;
  /// Adds the forces on walls that follow from these.
  virtual void add_wall_forces(B& backend, const Fluid& f, const Walls<D>& w,
                               WallForces<D, B>& forces) const = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

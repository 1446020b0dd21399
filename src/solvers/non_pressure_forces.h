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

/// Allocates the memory of fluid fields.
template <int D> struct FieldMaker {
  virtual ~FieldMaker() = default;
  virtual void make(const char* name, Keep keep, Field<Real>& field) = 0;
  virtual void make(const char* name, Keep keep, Field<Vec<D>>& field) = 0;
  virtual void make(const char* name, Keep keep, Field<int>& field) = 0;
};

/// The forces on a fluid beside pressure, gravity and walls: viscosity, surface tension, vorticity,
/// air drag, and particle shifting. A solver calls them through a pointer, which is null if there
/// are none. Each method is therefore compiled once per backend, not into every solver. A solver
/// calls it after the neighbour search, with rho computed and shared with copies.
template <int D, class B> struct NonPressureForces {
  using Fluid = FluidParticles<D>;
  virtual ~NonPressureForces() = default;
  virtual void fields(FieldMaker<D>& maker) = 0;

  /// Adds the accelerations to a, for a solver that integrates accelerations. The implicit solve
  /// starts from the velocity `from` + dt a, and its velocity change over dt is added to a. Without
  /// memory for `from` it is left to relax(). With dt = 0 nothing is advanced in time.
  virtual void accelerate(B& backend, const Fluid& f, const Walls<D>& w, Real dt,
                          Field<Vec<D>> from) = 0;
  /// Changes v by the implicit solve over dt, after a step.
  virtual void relax(B& backend, const Fluid& f, const Walls<D>& w, Real dt) = 0;
  /// Adds the accelerations to a, and dt times them to v, for a solver that predicts velocities.
  virtual void push(B& backend, const Fluid& f, const Walls<D>& w, Real dt) = 0;
  /// Shifts particles, at the end of a step of dt.
  virtual void shift(B& backend, const Fluid& f, Real dt) const = 0;

  /// Reduces the time-step bounds to those of these forces.
  virtual void bound(TimeStepBounds& bounds) const = 0;
  /// The result of the last step's implicit solve; empty without one.
  virtual std::optional<Solve> solve() const = 0;
  /// Adds the reactions of these forces to the forces on walls.
  virtual void add_wall_forces(const Fluid& f, const Walls<D>& w,
                               WallForces<D, B>& forces) const = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "engine/plan.h"
#include "engine/wall_forces.h"
#include "solvers/integrators.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A solver with its kernel, its symbols and the fields of its fluid, as an engine sees it: all
/// that is compiled anew for each solver.
template <int D, class B> class Stepper {
 public:
  virtual ~Stepper() = default;
  virtual FluidParticles<D>& fluid() = 0;
  /// Allots the fluid's fields beside id, x and v.
  virtual void fields(FieldMaker<D>& maker) = 0;
  virtual Confinement<D>& confinement() = 0;
  virtual void set_gravity(Vec<D> gravity) = 0;
  /// Forces beside pressure; null if there are none.
  virtual void set_forces(NonPressureForces<D, B>* forces) = 0;
  /// p/rho^2 that the first step starts from; null for solvers that do not solve for the pressure.
  virtual Field<Real>* start_pressure() = 0;

  virtual Solves step(B& backend, Walls<D>& walls, const Tick& tick) = 0;
  virtual TimeStepBounds bounds(B& backend) = 0;
  /// Adds the forces on walls by the solver's pair terms.
  virtual void add_wall_forces(B& backend, const Walls<D>& walls, WallForces<D, B>& forces) = 0;
};

/// Defined in a file of its own for each solver, backend and dimension, which is made from
/// instantiate/solver.cpp.in.
template <SolverName solver, int D, class B>
std::unique_ptr<Stepper<D, B>> make_stepper(const EnginePlan& plan);

/// The forces beside pressure of a plan; null if it has none. Defined in a file of its own for each
/// backend and dimension, which is made from instantiate/forces.cpp.in.
template <int D, class B>
std::unique_ptr<NonPressureForces<D, B>> make_forces(const EnginePlan& plan);

}  // namespace FRESHET_ISA
}  // namespace freshet

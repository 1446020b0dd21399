// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "engine/plan.h"
#include "engine/wall_forces.h"
#include "solvers/integrators.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The interface of a solver with its kernel, its parameters and its fluid. Only its
/// implementations are compiled once per solver.
template <int D, class B> class Stepper {
 public:
  virtual ~Stepper() = default;
  virtual FluidParticles<D>& fluid() = 0;
  /// Allocates the fluid's fields except id, x and v.
  virtual void fields(FieldMaker<D>& maker) = 0;
  virtual Confinement<D>& confinement() = 0;
  virtual void set_gravity(Vec<D> gravity) = 0;
  /// Sets the forces beside pressure; null: none.
  virtual void set_forces(NonPressureForces<D, B>* forces) = 0;
  /// The initial p/rho^2 of the first step; null for solvers that do not solve for the pressure.
  virtual Field<Real>* start_pressure() = 0;

  virtual Solves step(B& backend, Walls<D>& walls, const Tick& tick) = 0;
  virtual TimeStepBounds bounds(B& backend) = 0;
  /// Adds the forces on walls by the solver's pair terms.
  virtual void add_wall_forces(B& backend, const Walls<D>& walls, WallForces<D, B>& forces) = 0;
};

/// Makes the stepper of a solver. It is defined in one file per solver, backend and dimension, made
/// from instantiate/solver.cpp.in.
template <SolverName solver, int D, class B>
std::unique_ptr<Stepper<D, B>> make_stepper(const EnginePlan& plan);

/// Makes the forces beside pressure of a plan; null if it has none. It is defined in one file per
/// backend and dimension, made from instantiate/forces.cpp.in.
template <int D, class B>
std::unique_ptr<NonPressureForces<D, B>> make_forces(const EnginePlan& plan);

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/inlet_plan.h"
#include "freshet/frame.h"
#include "freshet/particles.h"
#include "freshet/report.h"
#include "freshet/state_array.h"
#include "freshet/time_step.h"
#include "freshet/whitewater.h"
#include "solvers/solve.h"

namespace freshet {

struct EnginePlan;

/// The interface of a solver on a backend, without templates, instruction sets and threads.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Takes a step of dt from `time` on [s]. Returns the results of its solves.
  virtual Solves step(double time, double dt) = 0;
  /// After an accepted step that ended at `time`: advances the whitewater, moves the particles that
  /// inlets hold, counts particles, and adds and removes particles.
  virtual void flow(double time, double dt) = 0;
  /// The number of particles through each of Scene::flow_names() since the start, then the number
  /// of particles that wait at each inlet.
  virtual std::vector<std::int64_t> flow_counts() const = 0;
  /// Resizes the fluid, or the whitewater if there is one, to n particles, whose state the caller
  /// writes.
  virtual void resize(std::int64_t n) = 0;
  virtual void resize_whitewater(std::int64_t n) = 0;
  /// Rolls the last step back. Only for pressure solvers.
  virtual void undo() = 0;
  /// The bounds of a step from `time` on [s], by the state and the accelerations of the last step.
  virtual TimeStepBounds bounds(double time) = 0;
  /// Its x is relative to its origin.
  virtual ParticleView fluid() const = 0;
  /// The positions, relative to the origin of fluid(), the velocities and the numbers of the
  /// liquids, to be written between steps.
  virtual std::span<Real> positions() = 0;
  virtual std::span<Real> velocities() = 0;
  virtual std::span<int> kinds() = 0;
  /// Keeps the array of the fluid that starts at `array`; see Simulation::keep.
  virtual std::shared_ptr<const void> keep(const void* array) = 0;
  /// Adds particles at rest density between steps, D numbers each, at positions in the scene.
  /// Returns the first one's id.
  virtual std::uint64_t add(std::span<const Real> x, std::span<const Real> v, int kind) = 0;
  /// Removes the particles at these places of fluid(), in ascending order.
  virtual void remove(std::span<const int> places) = 0;
  /// Changes gravity from the next step on [m/s^2].
  virtual void set_gravity(const Triple& gravity) = 0;
  /// Adds to the acceleration of each particle of fluid() at `time` [s], D numbers per particle
  /// [m/s^2]. An empty function adds nothing.
  using AddForce = std::function<void(double time, std::span<double> acceleration)>;
  virtual void set_force(AddForce force) = 0;
  virtual WhitewaterView whitewater() const = 0;
  virtual std::vector<BodyState> bodies() const = 0;
  /// The present force of the fluid on each wall in the order of Scene::wall_names() [N; N/m in
  /// 2D], 0 on reflecting walls.
  virtual std::vector<Vector> wall_forces() = 0;
  /// The impulse on each reflecting wall since the start [N s; N s/m in 2D], 0 on others.
  virtual std::vector<Vector> bounce_impulses() = 0;
  /// See Simulation::tractions; `cell` is the width of a boundary particle's share of the wall [m].
  virtual std::vector<Vector> tractions(const std::vector<WallPatch>& patches, double cell) = 0;
  /// See Simulation::boundary_forces.
  virtual BoundaryForces boundary_forces() = 0;
  /// Replaces the fluid and the bodies by those of a frame, to be measured: no step may follow.
  /// `moment` [s] is short in comparison to a step; moved bodies accelerate as within it.
  virtual void show(const Frame& frame, double moment) = 0;
  virtual const std::vector<VerbTiming>& timings() const = 0;
  /// All arrays of the state. Writing to them restores a state, after continue_from has set the
  /// number of steps.
  virtual std::vector<StateArray> state() = 0;
  virtual void continue_from(std::int64_t steps) = 0;
};

/// Makes an engine; null if the build lacks the plan's solver.
using MakeEngine = std::unique_ptr<Engine>(const EnginePlan&);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/state_array.h"
#include "freshet/report.h"
#include "freshet/scene.h"
#include "freshet/simulation.h"
#include "scene/setup.h"
#include "solvers/solve.h"

namespace freshet {

/// A solver on a backend, as the simulation sees it: no template, no instruction set, no threads.
class Engine {
 public:
  virtual ~Engine() = default;
  /// A step of dt from `time` on [s]. Returns its solves; none of a solver that does not iterate.
  virtual std::vector<Solve> step(double time, double dt) = 0;
  /// After a step that stands, which ended at `time`: moves what inlets hold, counts, and lets
  /// particles come and go.
  virtual void flow(double time, double dt) = 0;
  /// Of each of Scene::flow_names() the particles so far, then of each inlet those that wait.
  virtual std::vector<std::int64_t> flow_counts() const = 0;
  /// Makes the fluid have n particles, whose state is to be written.
  virtual void resize(std::int64_t n) = 0;
  /// Takes the last step back. Only for solvers that iterate: the others remember nothing.
  virtual void undo() = 0;
  /// The bounds of a step from `time` on, by the state and the accelerations of the last.
  virtual TimeStepBounds bounds(double time) = 0;
  virtual ParticleView fluid() const = 0;
  virtual std::vector<BodyState> bodies() const = 0;
  /// The force of the fluid on each wall in the order of Scene::wall_names() [N, N/m in 2D]:
  /// reflecting walls the mean over `interval` [s], the time since the last call; others now.
  virtual std::vector<Vector> wall_forces(double interval) = 0;
  /// See Simulation::tractions; `cell` is how wide a sample's share of the wall is [m].
  virtual std::vector<Vector> tractions(const std::vector<WallPatch>& patches, double cell) = 0;
  virtual const std::vector<VerbTiming>& timings() const = 0;
  /// All that the next steps follow from, besides the scene. What is written there is restored,
  /// once continue_from has told how many steps were taken.
  virtual std::vector<StateArray> state() = 0;
  virtual void continue_from(std::int64_t steps) = 0;
};

/// What an engine is made from.
struct EngineInput {
  const Scene& scene;
  const Derived& derived;
  const Sample& sample;
  int threads;
};
using MakeEngine = std::unique_ptr<Engine>(const EngineInput&);

}  // namespace freshet

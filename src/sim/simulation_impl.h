// SPDX-License-Identifier: MIT
/// What a simulation is made of.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bodies/bodies.h"
#include "engine/engine.h"
#include "freshet/simulation.h"
#include "scene/model/schedule.h"
#include "scene/model/setup.h"
#include "sim/far_positions.h"
#include "sim/health.h"
#include "sim/tight_walls.h"

namespace freshet {

/// Rejects too many threads for any backend; the reference has one.
inline int threads_of(const Scene& scene, const Execution& execution, double particles) {
  const int threads = thread_count(execution.threads, particles);
  return scene.solver.backend == BackendName::cpu ? threads : 1;
}

struct Simulation::Impl {
  Impl(Scene s, const Execution& e)
      : scene(with_defaults(std::move(s))),
        derived(derive(scene)),
        threads(threads_of(scene, e, derived.most_particles)),
        bodies(scene.body.empty() ? nullptr : std::make_unique<Bodies>(scene)),
        execution(e),
        tight_walls(scene, derived, bodies.get()),
        engine_(make_engine_of(e)) {
    health.emplace(scene, derived, engine_->fluid(), bodies.get());
  }
  std::unique_ptr<Engine> make_engine_of(const Execution& execution) const;
  /// The engine, after positions that the caller has written have reached it.
  Engine& engine() const {
    far_.write_back(*engine_);
    return *engine_;
  }
  /// The fluid at positions in the scene.
  ParticleView fluid() const { return far_.in_scene(engine().fluid()); }
  /// The positions in the scene, to be written.
  std::span<Real> edit_positions() { return far_.edit(engine()); }
  /// Call before the particles change their number or order.
  void end_edit() {
    engine();
    far_.end_edit();
  }
  /// Throws while the simulation shows a frame.
  void refuse_shown(const char* what) const;
  std::vector<StateArray> state() const;
  std::string state_digest(StateArray::Role role) const;
  class Resized;
  TimeStepBounds bounds() const;
  double next_step();
  double advance(double from, double dt, int halvings, double whole);
  void note(const Solves& solves);
  WhitewaterFrame whitewater_frame() const;

  Scene scene;
  Derived derived;
  int threads;
  std::unique_ptr<Bodies> bodies;  // null without bodies
  Execution execution;
  Force force;                    // of the caller; may be empty
  std::optional<Vector> gravity;  // of the caller, in place of the scene's
  std::int64_t steps = 0;
  double time = 0;
  bool edited = false;  // the caller has added or removed particles
  bool shown = false;   // show() was called since the last restore()
  std::vector<std::pair<Every, std::function<void(const Simulation&)>>> observers;
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  bool retries_help = true;
  std::optional<Health> health;  // refers to the scene
  TightWalls tight_walls;

 private:
  std::unique_ptr<Engine> engine_;
  mutable FarPositions far_;
};

}  // namespace freshet

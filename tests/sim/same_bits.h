// SPDX-License-Identifier: MIT
/// Tests for equal bits: the cpu backend against the reference backend, with every instruction set
/// and several numbers of threads; and runs that are restored from a checkpoint.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "io/checkpoint.h"
#include "sim/small_scenes.h"

namespace freshet::test {

/// Digests and results of a simulation.
struct Outcome {
  std::string state, kept;
  double time = 0;
  std::vector<Vector> forces;       ///< forces on walls
  std::vector<double> bodies;       ///< positions, orientations, velocities, loads
  std::vector<std::int64_t> flows;  ///< counts, waiting particles, rates in 1e-9
  std::vector<std::int64_t> steps;  ///< number of retried steps, and the iterations of each solve
};

inline Outcome outcome_of(Simulation& sim) {
  Outcome o{sim.state_sha256(), sim.kept_sha256(), sim.time(), sim.wall_forces(), {}, {}, {}};
  for (const BodyState& b : sim.bodies()) {
    for (const auto* three : {&b.position, &b.velocity, &b.angular_velocity, &b.force, &b.torque})
      o.bodies.insert(o.bodies.end(), three->begin(), three->end());
    o.bodies.insert(o.bodies.end(), b.orientation.begin(), b.orientation.end());
  }
  for (const Flow& flow : sim.flows()) {
    o.flows.push_back(flow.particles);
    o.flows.push_back(flow.waiting);
    o.flows.push_back(std::llround(1e9 * flow.rate));
  }
  o.steps.push_back(sim.time_steps().retried);
  for (const SolveStatistics& solve : sim.solves()) o.steps.push_back(solve.iterations);
  return o;
}

inline void expect_equal(const Outcome& a, const Outcome& b, const std::string& what) {
  EXPECT_EQ(a.state, b.state) << what;
  EXPECT_EQ(a.kept, b.kept) << what;
  EXPECT_EQ(a.time, b.time) << what;
  EXPECT_EQ(a.forces, b.forces) << what;
  EXPECT_EQ(a.bodies, b.bodies) << what;
  EXPECT_EQ(a.flows, b.flows) << what;
  EXPECT_EQ(a.steps, b.steps) << what;
}

/// Runs a scene on the reference and on the cpu backend and expects equal outcomes. `after_step` is
/// called after each step. Returns the outcome.
inline Outcome expect_same_bits(const std::string& scene, int steps,
                                const std::function<void(Simulation&)>& after_step = {}) {
  const auto run = [&](const char* backend, const Execution& execution) {
    Simulation sim = simulation_of(scene, backend, execution);
    for (int k = 0; k < steps; ++k) {
      sim.step();
      if (after_step) after_step(sim);
    }
    return outcome_of(sim);
  };
  const Outcome reference = run("reference", {});
  for (const std::string& isa : instruction_sets())
    for (const int threads : {7, 3, 2, 1})  // descending: clang's libomp leaks when a team grows
      expect_equal(reference, run("cpu", {threads, isa}),
                   isa + " on " + std::to_string(threads) + " threads\n" + scene);
  return reference;
}

/// Takes a checkpoint after `before` steps, through the bytes of a file. Restores it into a fresh
/// simulation with another number of threads, and into the first one, which has continued. After
/// `more` steps both must equal the uninterrupted run.
inline void expect_same_bits_after_restart(const std::string& scene, int before, int more) {
  const auto step = [](Simulation& sim, int steps) {
    for (int k = 0; k < steps; ++k) sim.step();
  };
  for (const char* backend : {"reference", "cpu"}) {
    Simulation first = simulation_of(scene, backend, {2, ""});
    step(first, before);
    const Checkpoint saved =
        decode_checkpoint(encode_checkpoint(first.checkpoint()), "a checkpoint");
    step(first, more);
    const Outcome expected = outcome_of(first);
    Simulation second = simulation_of(scene, backend, {1, ""});
    for (Simulation* sim : {&second, &first}) {
      sim->restore(saved);
      EXPECT_EQ(sim->steps_done(), before);
      step(*sim, more);
      expect_equal(expected, outcome_of(*sim), std::string(backend) + "\n" + scene);
    }
  }
}

}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/forced.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

/// A column of water that breaks at the far wall, over a block.
std::string breaking(int dimension, const std::string& solver, const std::string& more) {
  const bool solid = dimension == 3;
  return std::string("[domain]\nmax = ") + (solid ? "[1, 0.8, 0.2]" : "[1, 0.8]") +
         "\n[particles]\nspacing = 0.04\n[fluid]\nmin = " + (solid ? "[0, 0, 0]" : "[0, 0]") +
         "\nmax = " + (solid ? "[0.4, 0.6, 0.2]" : "[0.4, 0.6]") +
         "\n[[wall]]\nmin = " + (solid ? "[0.7, 0, 0]" : "[0.7, 0]") +
         "\nmax = " + (solid ? "[0.8, 0.16, 0.2]" : "[0.8, 0.16]") + "\n[solver]\nname = \"" +
         solver + "\"\n[time]\nend = 1\nstep = \"adaptive\"\nstep_max = 0.004\n" + more;
}

/// Low limits, so that a coarse and short run has many.
const char* const much =
    "[whitewater]\ntrapped_air_limits = [0.2, 1]\nspeed_limits = [0.5, 2]\nlifetime = [0.05, "
    "0.2]\n";

bool have_same_bits(const WhitewaterFrame& a, const WhitewaterFrame& b) {
  return a.id == b.id && a.x == b.x && a.v == b.v && a.kind == b.kind && a.age == b.age;
}

void run(Simulation& sim, double until) {
  while (sim.time() < until) sim.step();
}

struct Case {
  int dimension;
  const char* solver;
};
class Whitewater : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!compiled(GetParam().solver)) GTEST_SKIP() << "not compiled in this build";
  }
  std::string scene(const std::string& more) const {
    return breaking(GetParam().dimension, GetParam().solver, more);
  }
};

TEST_P(Whitewater, LeavesTheFluidItsBits) {
  Simulation with = simulation_of(scene(much)), without = simulation_of(scene(""));
  for (int k = 0; k < 4; ++k) {
    run(with, 0.15 * (k + 1));
    run(without, 0.15 * (k + 1));
    const Outcome a = outcome_of(with), b = outcome_of(without);
    EXPECT_EQ(b.state, a.state);
    EXPECT_EQ(b.kept, a.kept);
    EXPECT_EQ(b.forces, a.forces);
  }
  EXPECT_GT(with.whitewater().size(), 50u);
  EXPECT_EQ(0u, without.whitewater().size());
}

TEST_P(Whitewater, HasTheReferencesBitsForAnyThreads) {
  Simulation reference = simulation_of(scene(much), "reference"),
             one = simulation_of(scene(much), "cpu", {1, {}}),
             three = simulation_of(scene(much), "cpu", {3, {}});
  for (Simulation* sim : {&reference, &one, &three}) run(*sim, 0.5);
  const WhitewaterFrame expected = reference.frame().whitewater;
  EXPECT_GT(expected.size(), 50u);
  EXPECT_TRUE(have_same_bits(expected, one.frame().whitewater));
  EXPECT_TRUE(have_same_bits(expected, three.frame().whitewater));
}

TEST_P(Whitewater, IsResumedToTheSameBits) {
  Simulation sim = simulation_of(scene(much)), resumed = simulation_of(scene(much));
  run(sim, 0.45);
  resumed.restore(sim.checkpoint());
  EXPECT_TRUE(have_same_bits(sim.frame().whitewater, resumed.frame().whitewater));
  run(sim, 0.6);
  run(resumed, 0.6);
  EXPECT_GT(sim.whitewater().size(), 50u);
  EXPECT_TRUE(have_same_bits(sim.frame().whitewater, resumed.frame().whitewater));
  resumed.restore(simulation_of(scene(much)).checkpoint());  // to the start, without any
  EXPECT_EQ(0u, resumed.whitewater().size());
}

// Between two looks at the walls a particle moves by up to 0.7 spacings; at the sides of the domain
// it is stopped at once. A new particle is born within half a spacing of its fluid particle.
TEST_P(Whitewater, StaysOutOfWalls) {
  Simulation sim = simulation_of(scene(much));
  double beyond = 0, deepest = 0;
  std::size_t seen = 0;
  for (int k = 1; k < 16; ++k) {
    run(sim, 0.05 * k);
    const WhitewaterFrame w = sim.frame().whitewater;
    const auto D = std::size_t(sim.scene().dimension());
    seen += w.size();
    for (std::size_t i = 0; i < w.size(); ++i) {
      const double x = double(w.x[D * i]), y = double(w.x[D * i + 1]);
      beyond = std::max({beyond, -x, x - 1, -y, y - 0.8});
      deepest = std::max(deepest, std::min({x - 0.7, 0.8 - x, 0.16 - y}));  // in the block
    }
  }
  EXPECT_GT(seen, 500u);
  EXPECT_LT(beyond, 1e-6);
  EXPECT_LT(deepest, 0.7 * sim.scene().particles.spacing);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Whitewater,
                         testing::Values(Case{2, "wcsph"}, Case{3, "wcsph"}, Case{2, "dfsph"},
                                         Case{3, "dfsph"}, Case{2, "delta_sph"}),
                         [](const auto& scene) {
                           return std::string(scene.param.solver) +
                                  std::to_string(scene.param.dimension) + "d";
                         });

TEST(WhitewaterOfScenes, IsNotBornInStillWater) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [0.4, 0.4]\n[particles]\nspacing = 0.02\n[fluid]\nmin = [0, 0]\n"
      "max = [0.4, 0.2]\npressure = \"hydrostatic\"\n[solver]\nname = \"wcsph\"\n[time]\n"
      "end = 0.5\nstep = \"adaptive\"\nstep_max = 0.01\n[whitewater]\n");
  while (!sim.finished()) sim.step();
  EXPECT_EQ(0u, sim.whitewater().size());
}

TEST(WhitewaterOfScenes, ReportsBirthsWithoutRoom) {
  Simulation sim = simulation_of(breaking(2, "wcsph", std::string(much) + "max_particles = 20\n"));
  run(sim, 0.6);
  EXPECT_EQ(20u, sim.whitewater().size());
  EXPECT_GT(sim.whitewater().refused, 0u);
  const auto& warnings = sim.warnings();
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const Warning& w) { return w.kind == "whitewater"; }));
}

TEST(WhitewaterOfScenes, DependsOnItsSeed) {
  Simulation a = simulation_of(breaking(2, "wcsph", much)),
             b = simulation_of(breaking(2, "wcsph", std::string(much) + "seed = 1\n"));
  run(a, 0.5);
  run(b, 0.5);
  EXPECT_GT(a.whitewater().size(), 20u);
  EXPECT_FALSE(have_same_bits(a.frame().whitewater, b.frame().whitewater));
}

/// Restores a checkpoint in which one number is another, and goes on.
template <class T> std::string outcome_of_forged(const std::string& name, std::size_t at, T value) {
  Simulation sim = simulation_of(breaking(2, "wcsph", much));
  run(sim, 0.45);
  Checkpoint c = sim.checkpoint();
  const auto a = std::find_if(c.arrays.begin(), c.arrays.end(),
                              [&](const StateArray& b) { return b.name == name; });
  if (a == c.arrays.end()) return "no " + name;
  std::memcpy(a->bytes.data() + at * sizeof value, &value, sizeof value);
  try {
    sim.restore(c);
    run(sim, 0.5);
  } catch (const Error& e) {
    return e.what();
  }
  for (const Real x : sim.frame().whitewater.x)
    if (!std::isfinite(x)) return "NaN";
  return "good";
}

TEST(WhitewaterOfScenes, IsCheckedInCheckpoints) {
  const auto expect = [](const std::string& words, const std::string& outcome) {
    EXPECT_NE(std::string::npos, outcome.find(words)) << outcome;
  };
  expect("good", outcome_of_forged("whitewater/kind", 0, 1));
  expect("not 0 to 2", outcome_of_forged("whitewater/kind", 0, 3));
  expect("NaN or infinite", outcome_of_forged("whitewater/v", 0, Real(NAN)));
  expect("the next id is", outcome_of_forged("whitewater_clock/next_id", 0, std::uint64_t(0)));
  expect("since the whitewater", outcome_of_forged("whitewater_clock/elapsed", 0, -1.0));
  expect("since the whitewater", outcome_of_forged("whitewater_clock/elapsed", 0, 1e300));
  // particles far away and fast ones leave the domain
  expect("good", outcome_of_forged("whitewater/x", 0, Real(3e38)));
  expect("good", outcome_of_forged("whitewater/x", 1, Real(-3e38)));
  expect("good", outcome_of_forged("whitewater/v", 0, Real(3e38)));
  expect("good", outcome_of_forged("whitewater/age", 0, Real(3e38)));
  expect("good", outcome_of_forged("whitewater/life", 0, Real(3e38)));
}

}  // namespace
}  // namespace freshet::test

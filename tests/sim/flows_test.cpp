// SPDX-License-Identifier: MIT
// Inlets, outlets and counters: exact numbers of particles, and the same bits on every backend and
// after a restart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/select.h"
#include "freshet/derived.h"
#include "io/checkpoint.h"
#include "run/observables.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

/// An empty box with an inlet at its centre line: four particles wide, directed to the right.
std::string jet(const std::string& inlet, const std::string& time, const std::string& more = "",
                const std::string& solver = "name = \"wcsph\"\nsound_speed = 30\n") {
  return "[domain]\nmax = [1.6, 1.0]\ngravity = [0, 0]\n[particles]\nspacing = 0.05\n"
         "[[inlet]]\nname = \"tap\"\ncenter = [0.4, 0.5]\ndirection = [2, 0]\nwidth = 0.2\n" +
         inlet + more + "[solver]\n" + solver + "[time]\nend = 10\n" + time;
}

/// One thread, since there are few particles.
Simulation small(const std::string& text) { return simulation_of(text, "cpu", {1, ""}); }

void run_until(Simulation& sim, double time) {
  while (sim.time() < time * (1 - 1e-9)) sim.step();
}

std::set<std::uint64_t> ids(const Simulation& sim) {
  const auto f = sim.fluid();
  return {f.id.begin(), f.id.end()};
}

// Layer k passes the opening at (k + 1/2) spacing/speed; held layers are behind it. After 0.31 s at
// 2 m/s the flow has moved by 12.4 spacings.
TEST(Inlet, EmitsTheExactNumberOfParticlesWithAnyStep) {
  for (const char* step :
       {"step = 0.001", "step = 0.0007", "step = 0.05", "step = \"adaptive\"\nstep_max = 0.01"}) {
    Simulation sim = small(jet("speed = 2\n", step + std::string("\n")));
    while (sim.time() < 0.31 - 1e-9) {
      sim.step();
      const double gone = 2 * sim.time() / 0.05;
      const auto through = std::int64_t(std::floor(gone + 0.5 + 1e-9));
      // new layers start half a spacing inside the back of the zone
      const auto born = std::int64_t(std::floor(gone + 1e-9)) + 3;
      ASSERT_EQ(4 * through, sim.flows()[0].particles) << step << " at " << sim.time();
      ASSERT_EQ(std::size_t(4 * born), sim.fluid().size()) << step << " at " << sim.time();
    }
    EXPECT_EQ(sim.fluid().size(), ids(sim).size());
    EXPECT_EQ(sim.fluid().size() - 1, *ids(sim).rbegin()) << "ids must be consecutive";
  }
}

TEST(Inlet, HoldsItsLatticeInPlace) {
  Simulation sim = small(jet("speed = 2\n", "step = 0.0013\n"));
  for (int k = 0; k < 57; ++k) sim.step();
  const auto f = sim.fluid();
  int held = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double x = f.x[2 * i], y = f.x[2 * i + 1];
    if (x >= 0.4) continue;
    ++held;
    const double layers = (x - 0.4 - 2 * sim.time()) / 0.05 + 0.5, places = (y - 0.425) / 0.05;
    EXPECT_NEAR(layers, std::round(layers), 1e-5);
    EXPECT_NEAR(places, std::round(places), 1e-5);
    EXPECT_EQ(Real(2), f.v[2 * i]);
    EXPECT_EQ(Real(0), f.v[2 * i + 1]);
  }
  EXPECT_EQ(8, held) << "two layers are held, 0.54 and 1.54 spacings behind the opening";
}

TEST(Inlet, KeepsItsFlowRateIfTheLatticeDoesNotFitItsWidth) {
  std::string text = jet("flow_rate = 0.3\n", "step = 0.001\n");
  text.replace(text.find("width = 0.2"), 11, "width = 0.23");  // 4.6 spacings become 5
  Simulation sim = small(text);
  run_until(sim, 0.4);
  const Flow flow = sim.flows()[0];
  EXPECT_NEAR(0.3 * 0.4, flow.volume, 5 * 0.05 * 0.05);
  EXPECT_NEAR(0.3, flow.rate, 5 * 0.05 * 0.05 / 0.4);
}

TEST(Inlet, EmitsBetweenItsStartAndStop) {
  Simulation sim = small(jet("speed = 2\nstart = 0.03\nstop = 0.27\n", "step = 0.001\n"));
  EXPECT_EQ(0u, sim.fluid().size());
  run_until(sim, 0.029);
  EXPECT_EQ(0u, sim.fluid().size());
  run_until(sim, 0.03);
  EXPECT_EQ(12u, sim.fluid().size()) << "the zone must be filled";
  run_until(sim, 0.5);
  EXPECT_EQ(40, sim.flows()[0].particles) << "0.24 s at 2 m/s are 9.6 spacings, that is 10 layers";
  EXPECT_EQ(40u, sim.fluid().size());
}

TEST(Inlet, FillsAnEmptySceneWithEverySolver) {
  for (const char* solver : {"wcsph", "delta_sph", "pcisph", "iisph", "dfsph", "pbf"})
    for (const char* backend : {"reference", "cpu"}) {
      const bool weakly = solver == std::string("wcsph") || solver == std::string("delta_sph");
      const std::string text =
          jet("speed = 1\nstart = 0.011\n", "step = \"adaptive\"\nstep_max = 0.002\n",
              "[walls]\nmethod = \"ghost\"\n",
              "name = \"" + std::string(solver) + "\"\n" + (weakly ? "sound_speed = 20\n" : ""));
      const Scene scene = parse_scene(text, "test.toml", {{"solver.backend", backend}});
      if (!has_solver(scene.solver.name)) continue;
      Simulation sim(scene);
      EXPECT_EQ(0, sim.statistics().particles);
      EXPECT_EQ(0u, sim.frame().size());
      sim.wall_forces();
      run_until(sim, 0.01);
      EXPECT_EQ(0u, sim.fluid().size()) << solver;
      run_until(sim, 0.1);
      sim.wall_forces();
      EXPECT_EQ(0, sim.statistics().out_of_bounds) << solver;
      EXPECT_EQ(8, sim.flows()[0].particles) << solver << ": 0.089 s are 1.78 layers";
      for (const SolveStatistics& s : sim.solves()) EXPECT_EQ(0, s.not_converged) << solver;
    }
}

constexpr const char* outlet = "[[outlet]]\nname = \"drain\"\nmin = [1.2, 0]\nmax = [2, 1]\n";
constexpr const char* counters =
    "[[counter]]\nname = \"all\"\ncenter = [0.8, 0]\ndirection = [3, 0]\n"
    "[[counter]]\nname = \"back\"\ncenter = [0.8, 0]\ndirection = [-1, 0]\n"
    "[[counter]]\nname = \"lower half\"\ncenter = [0.8, 0.2]\ndirection = [1, 0]\nwidth = 0.6\n"
    "[[counter]]\nname = \"beside\"\ncenter = [0.8, 0.9]\ndirection = [1, 0]\nwidth = 0.1\n";

TEST(Counter, CountsTheFlowOfTheInlet) {
  Simulation sim = small(
      jet("speed = 2\n", "step = \"adaptive\"\nstep_max = 0.01\n", std::string(outlet) + counters));
  run_until(sim, 1);
  const Simulation::Moment since = sim.moment();
  run_until(sim, 3);
  const auto flows = sim.flows(since);
  ASSERT_EQ(6u, flows.size());
  EXPECT_EQ("drain", flows[1].name);
  const double rate = 2 * 0.2;
  for (const int k : {0, 1, 2}) EXPECT_NEAR(rate, flows[std::size_t(k)].rate, 0.01 * rate);
  EXPECT_EQ(-flows[2].particles, flows[3].particles);
  EXPECT_NEAR(rate / 2, flows[4].rate, 0.01 * rate);
  EXPECT_EQ(0, flows[5].particles);
  // each particle that entered is still there or has left
  EXPECT_EQ(flows[0].particles + 12 - flows[1].particles, std::int64_t(sim.fluid().size()));
  for (std::size_t i = 0; i < sim.fluid().size(); ++i) EXPECT_LE(sim.fluid().x[2 * i], 1.2f);
}

TEST(Counter, CountsAcrossAPeriodicEnd) {
  const std::string text =
      "[domain]\nmax = [1.0, 0.5]\ngravity = [0, 0]\nperiodic = \"xy\"\n[particles]\nspacing = "
      "0.05\n"
      "[fluid]\nmin = [0, 0]\nmax = [1.0, 0.5]\nvelocity = [2, 0]\n"
      "[[counter]]\ncenter = [0, 0]\ndirection = [1, 0]\n"
      "[[counter]]\ncenter = [0.5, 0]\ndirection = [1, 0]\n"
      "[solver]\nname = \"wcsph\"\nsound_speed = 30\n[time]\nend = 2\nstep = 0.0005\n";
  Simulation sim = small(text);
  run_until(sim, 1.01);  // slightly more than two rounds
  for (const Flow& flow : sim.flows()) EXPECT_EQ(400, flow.particles) << flow.name;
}

// The first particles of a layer that reach the outlet wait for the others.
TEST(Recycling, ReturnsParticlesThatLeave) {
  const char* round =
      "[[outlet]]\nname = \"drain\"\nshape = \"sphere\"\ncenter = [1.3, 0.6]\nradius = 0.3\n";
  Simulation sim = small(
      jet("speed = 2\nrecycle = \"drain\"\n", "step = \"adaptive\"\nstep_max = 0.01\n", round));
  EXPECT_EQ(12u, sim.fluid().size()) << "only the zone is filled at the start";
  bool waited = false;
  while (sim.time() < 1.5) {
    sim.step();
    const auto flows = sim.flows();
    ASSERT_EQ(12, std::int64_t(sim.fluid().size()) + flows[0].waiting) << sim.time();
    waited |= flows[0].waiting > 0;
  }
  EXPECT_TRUE(waited);
  const auto flows = sim.flows();
  EXPECT_GT(flows[1].particles, 20) << "particles must pass the outlet more than once";
  EXPECT_GT(*ids(sim).rbegin(), 30u) << "ids must not be reused";
}

/// Jets that hit a wall, a drain that feeds one of them, and walls of several methods.
std::string river(const std::string& solver, const std::string& time) {
  return "[domain]\nmax = [1.6, 1.0]\n[particles]\nspacing = 0.05\n"
         "[[fluid]]\nmin = [0.6, 0]\nmax = [1.2, 0.3]\n"
         "[[inlet]]\nname = \"tap\"\ncenter = [0.3, 0.5]\ndirection = [1, -0.5]\nwidth = 0.2\n"
         "speed = 2.3\n"
         "[[inlet]]\nname = \"again\"\ncenter = [1.2, 0.8]\ndirection = [-1, 0]\nwidth = 0.15\n"
         "speed = 1.7\nstart = 0.02\nrecycle = \"drain\"\n"
         "[[outlet]]\nname = \"drain\"\nmin = [1.0, 0]\nmax = [1.6, 0.2]\n"
         "[[counter]]\ncenter = [0.8, 0]\ndirection = [1, 0]\n"
         "[walls]\nx_min = \"reflection\"\ny_min = \"ghost\"\n[solver]\n" +
         solver + "[time]\nend = 1\n" + time;
}
constexpr const char* fixed = "step = 0.001\n";
constexpr const char* adaptive = "step = \"adaptive\"\nstep_max = 0.004\n";

struct Words {
  const char *solver, *time;
};
void PrintTo(const Words& w, std::ostream* out) { *out << w.solver << w.time; }
class Flows : public ::testing::TestWithParam<Words> {
 protected:
  void SetUp() override {
    text_ = river(GetParam().solver, GetParam().time);
    if (!has_solver(parse_scene(text_, "test.toml").solver.name))
      GTEST_SKIP() << "not compiled in this build";
  }
  std::string text_;
};

TEST_P(Flows, HaveTheReferencesBits) {
  const Outcome reference = expect_same_bits(text_, 60, [](Simulation& sim) {
    if (sim.steps_done() % 20 == 8) sim.wall_forces();
  });
  EXPECT_GT(reference.flows[6], 10) << "particles must have left through the drain";
}

// Whatever a caller asked for before: the forces on walls are a function of the state.
TEST_P(Flows, HaveWallForcesThatDoNotDependOnEarlierQueries) {
  Simulation asked = simulation_of(text_, "cpu", {1, ""}),
             quiet = simulation_of(text_, "cpu", {1, ""});
  for (int k = 0; k < 60; ++k) {
    asked.step();
    quiet.step();
    asked.wall_forces();
  }
  EXPECT_EQ(asked.wall_forces(), quiet.wall_forces());
  EXPECT_EQ(asked.kept_sha256(), quiet.kept_sha256());
}

// Restored into simulations that have fewer particles, and others.
TEST_P(Flows, ResumeToTheSameBits) { expect_same_bits_after_restart(text_, 64, 30); }

INSTANTIATE_TEST_SUITE_P(
    OfSolvers, Flows,
    ::testing::Values(Words{"name = \"wcsph\"\nsound_speed = 30\n", adaptive},
                      Words{"name = \"wcsph\"\nsound_speed = 30\n",
                            "step = 0.0005\nintegrator = \"leapfrog\"\n"},
                      Words{"name = \"delta_sph\"\nsound_speed = 30\n", "step = 0.0005\n"},
                      Words{"name = \"pcisph\"\n", fixed}, Words{"name = \"iisph\"\n", fixed},
                      Words{"name = \"dfsph\"\n", adaptive},
                      Words{"name = \"dfsph\"\nmax_iterations = 3\n", "step = 0.004\n"},
                      Words{"name = \"pbf\"\n", fixed}));

TEST(Restart, OfAnotherSceneChangesNothing) {
  Simulation sim = small(jet("speed = 2\n", fixed));
  for (int k = 0; k < 40; ++k) sim.step();
  Simulation other = small(jet("speed = 2\n", fixed, counters));
  for (int k = 0; k < 90; ++k) other.step();
  const std::string before = other.kept_sha256();
  EXPECT_THROW(other.restore(sim.checkpoint()), Error);
  EXPECT_EQ(before, other.kept_sha256());
  other.step();
}

TEST(Restart, OfAnEmptyFluidRemovesAllParticles) {
  const std::string text = jet("speed = 2\nstart = 0.01\n", fixed);
  Simulation sim = small(text);
  sim.step();
  const Checkpoint empty = decode_checkpoint(encode_checkpoint(sim.checkpoint()), "a checkpoint");
  for (int k = 0; k < 40; ++k) sim.step();
  const std::string state = sim.kept_sha256();
  sim.restore(empty);
  EXPECT_EQ(0u, sim.fluid().size());
  for (int k = 0; k < 40; ++k) sim.step();
  EXPECT_EQ(state, sim.kept_sha256());
}

TEST(FlowsOfAScene, AreInTheDerivedNumbers) {
  const Scene scene = parse_scene(jet("speed = 2\nstop = 0.27\n", fixed, outlet), "test.toml");
  const Derived d = derive(scene);
  EXPECT_EQ(12, d.particles);
  EXPECT_GE(d.most_particles, 44);
  EXPECT_LE(d.most_particles, 44 + 12);
  ASSERT_EQ(1u, d.inlets.size());
  EXPECT_EQ("tap", d.inlets[0].name);
  EXPECT_EQ(4, d.inlets[0].particles);
  EXPECT_DOUBLE_EQ(0.4, d.inlets[0].rate);
}

TEST(FlowsOfAScene, HaveColumnsInTheObservables) {
  Simulation sim = small(jet("speed = 2\n", fixed, outlet));
  const std::string header = observables_header(sim.scene());
  EXPECT_NE(std::string::npos,
            header.find(",particles,volume through tap [m^2],flow through tap [m^2/s],"
                        "volume through drain [m^2],flow through drain [m^2/s],force on x_min"));
  for (int k = 0; k < 50; ++k) sim.step();
  const auto flows = sim.flows();
  const std::string line = observables_line(sim, sim.wall_forces(), flows);
  EXPECT_EQ(std::count(header.begin(), header.end(), ','),
            std::count(line.begin(), line.end(), ','));
  EXPECT_NE(std::string::npos, line.find(",20,0.02,0.4,0,0,")) << line;
}

TEST(Inlet, EmitsItsOwnLiquid) {
  const std::string fluid =
      "rest_density = 400\n[[fluid]]\nmin = [1, 0]\nmax = [1.6, 0.2]\nrest_density = 1000\n";
  for (const char* backend : {"reference", "cpu"}) {
    Simulation sim = simulation_of(jet("speed = 2\n" + fluid, "step = 0.0003\n"), backend, {1, ""});
    for (int k = 0; k < 300; ++k) sim.step();
    const auto f = sim.fluid();
    std::int64_t light = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      EXPECT_EQ(f.id[i] >= 48, f.liquid[i] == 1);
      light += f.liquid[i];
      EXPECT_LT(f.density[i], f.liquid[i] ? 420 : 1050);
    }
    EXPECT_EQ(std::int64_t(f.size()) - 48, light);
    EXPECT_GT(light, 12);
  }
}

TEST(Inlet, EmitsTheFirstFluidsLiquidUnlessItSetsAnother) {
  const std::string fluid =
      "[[fluid]]\nmin = [1, 0]\nmax = [1.6, 0.2]\nrest_density = 900\nviscosity = 0.5\n"
      "color = \"#ff0000\"\n";
  const std::vector<Override> morris{{"solver.viscosity_method", "morris1997"}};
  const Scene same = parse_scene(jet("speed = 2\n" + fluid, fixed), "test.toml", morris);
  EXPECT_EQ(1u, same.liquids().size());
  const Scene::Liquid liquid = same.inlet_liquid(0);
  EXPECT_EQ(900, liquid.rest_density);
  EXPECT_EQ(0.5, liquid.viscosity);
  EXPECT_EQ("#ff0000", liquid.color);
  const Scene other =
      parse_scene(jet("speed = 2\nviscosity = 0.1\n" + fluid, fixed), "test.toml", morris);
  EXPECT_EQ(2u, other.liquids().size()) << "inlet.viscosity is used with morris1997";
}

// The openings are a disc and a rectangle in an oblique plane.
TEST(Inlet, EmitsItsFlowRateIn3D) {
  for (const char* opening : {"radius = 0.16\n", "width = 0.3\nheight = 0.2\nup = [0, 0, 1]\n"}) {
    const std::string text =
        "[domain]\nmax = [1, 1, 1]\n[particles]\nspacing = 0.05\n"
        "[inlet]\ncenter = [0.5, 0.6, 0.5]\ndirection = [1, -2, 0.5]\nflow_rate = 0.2\n" +
        std::string(opening) +
        "[solver]\nname = \"wcsph\"\nsound_speed = 60\n[time]\nend = 1\nstep = 0.0005\n";
    Simulation sim = small(text);
    run_until(sim, 0.1);
    const Flow flow = sim.flows()[0];
    EXPECT_NEAR(0.02, flow.volume, 32 * std::pow(0.05, 3)) << opening;
  }
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// The fluid that leaves through an open side is removed and counted, and no longer rules the run.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/select.h"
#include "run/observables.h"
#include "scene/model/expressions.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

/// A block of water of 64 particles that runs off a table through open sides.
std::string waterfall(const std::string& solver, const std::string& sides) {
  return "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.05\n"
         "[fluid]\nmin = [0.0, 0.5]\nmax = [0.4, 0.9]\n"
         "[[wall]]\nname = \"table\"\nmin = [0.0, 0.3]\nmax = [0.6, 0.46]\n[walls]\n" +
         sides + "[solver]\nname = \"" + solver +
         "\"\n[time]\nend = 4\nstep = \"adaptive\"\nstep_max = 0.005\n";
}

constexpr const char* sides = "y_min = \"open\"\nx_max = \"open\"\n";

void finish(Simulation& sim) {
  while (!sim.finished()) sim.step();
}

TEST(OpenSide, TakesWhatLeaves) {
  for (const char* solver : {"wcsph", "delta_sph", "dfsph", "pbf"}) {
    SCOPED_TRACE(solver);
    if (!has_solver(parse_scene(waterfall(solver, sides), "").solver.name)) continue;
    Simulation sim = simulation_of(waterfall(solver, sides), "cpu", {1, ""});
    const auto start = std::int64_t(sim.fluid().size());
    finish(sim);
    const auto flows = sim.flows();
    ASSERT_EQ(2u, flows.size());
    EXPECT_EQ("open side", flows[0].kind);
    EXPECT_EQ("x_max", flows[0].name);
    EXPECT_EQ("y_min", flows[1].name);
    EXPECT_EQ(start, std::int64_t(sim.fluid().size()) + flows[0].particles + flows[1].particles);
    EXPECT_GT(flows[1].particles, start / 4);
    EXPECT_NEAR(flows[1].volume, 0.05 * 0.05 * double(flows[1].particles), 1e-12);
    const ParticleView f = sim.fluid();
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_GT(f.x[2 * i + 1], -0.25);
    EXPECT_LT(sim.statistics().speed_max, std::sqrt(2 * 9.81 * 1.2) + 1)
        << "what fell for 4 s would have 30 m/s";
    EXPECT_TRUE(sim.warnings().empty());
  }
}

TEST(OpenSide, IsAColumnOfTheObservables) {
  const std::string header =
      observables_header(parse_scene(waterfall("wcsph", sides), "test.toml"));
  EXPECT_NE(header.find(",particles,volume through x_max [m^2],flow through x_max [m^2/s],"
                        "volume through y_min [m^2]"),
            std::string::npos)
      << header;
}

TEST(OpenSide, AbovePulledBackFluidTakesNothing) {
  std::string text = waterfall("wcsph", "method = \"akinci2012\"\ny_max = \"open\"\n");
  text.insert(text.find("[[wall]]"), "velocity = [0, 5]\n");
  text.replace(text.find("end = 4"), 7, "end = 1.2");
  Simulation sim = simulation_of(text, "cpu", {1, ""});
  const std::size_t start = sim.fluid().size();
  double top = 0;
  while (!sim.finished()) {
    sim.step();
    for (std::size_t k = 1; k < sim.fluid().x.size(); k += 2)
      top = std::max(top, double(sim.fluid().x[k]));
  }
  EXPECT_GT(top, 1.5) << "it must rise by 1.27 m";
  EXPECT_EQ(start, sim.fluid().size());
  EXPECT_LT(sim.statistics().height_mean, 0.8) << "it must fall back";
}

TEST(OpenSide, TakesWhatFliesOverAClosedOne) {
  std::string text = waterfall("wcsph", "y_max = \"open\"\n");
  text.insert(text.find("[[wall]]"), "velocity = [4, 5]\n");
  Simulation sim = simulation_of(text, "cpu", {1, ""});
  const auto start = std::int64_t(sim.fluid().size());
  finish(sim);
  EXPECT_GT(sim.flows()[0].particles, 20);
  EXPECT_EQ(start, std::int64_t(sim.fluid().size()) + sim.flows()[0].particles);
}

TEST(OpenSide, OfABodyForceThatPullsBackTakesNothing) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const std::string text =
      "[domain]\nmax = [1, 1]\ngravity = [0, 0]\nbody_force = [\"25*(0.5 - x)\", \"25*(0.5 - "
      "y)\"]\n"
      "[particles]\nspacing = 0.05\n[fluid]\nmin = [0.4, 0.4]\nmax = [0.6, 0.6]\n"
      "velocity = [8, 0]\n[walls]\nmethod = \"open\"\n[solver]\nname = \"wcsph\"\nsound_speed = "
      "80\n"
      "[time]\nend = 0.7\nstep = \"adaptive\"\nstep_max = 0.002\n";
  Simulation sim = simulation_of(text, "cpu", {1, ""});
  const std::size_t start = sim.fluid().size();
  double right = 0;
  while (!sim.finished()) {
    sim.step();
    right = std::max(right, double(sim.fluid().x[0]));
  }
  EXPECT_GT(right, 1.5) << "the drop must swing far out of the domain";
  EXPECT_EQ(start, sim.fluid().size());
}

TEST(OpenSide, HasTheSameBitsEverywhere) {
  const std::string flows =
      "[[outlet]]\nname = \"hole\"\nmin = [0.7, 0.6]\nmax = [0.75, 0.7]\n"
      "[[counter]]\ncenter = [0.8, 0.0]\ndirection = [1, 0]\n";
  for (const char* solver : {"mueller2003", "wcsph", "dfsph"})
    for (const std::string& more : {std::string(), flows}) {
      std::string text = waterfall(solver, sides) + more;
      text.insert(text.find("[[wall]]"), "velocity = [8, 0]\n");
      const int steps = solver == std::string("dfsph") ? 60 : 600;
      const Outcome o = expect_same_bits(text, steps);
      EXPECT_GT(o.flows[o.flows.size() - 6], 0) << "none has left: the test shows nothing";
      expect_same_bits_after_restart(text, steps * 3 / 4, steps / 4);
    }
}

}  // namespace
}  // namespace freshet::test

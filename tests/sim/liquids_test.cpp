// SPDX-License-Identifier: MIT
// Several liquids at once: layers, weights, momentum, and two equal liquids against one.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/select.h"
#include "io/checkpoint.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

/// A tank 0.4 m wide: 0.2 m of one liquid below 0.2 m of another, with these densities.
std::string tank(const std::string& solver, double below, double above, const std::string& more,
                 const std::string& time) {
  const auto fluid = [](const char* low, const char* high, double density) {
    return std::string("[[fluid]]\nmin = [0, ") + low + "]\nmax = [0.4, " + high +
           "]\npressure = \"hydrostatic\"\nrest_density = " + std::to_string(density) + "\n";
  };
  return "[domain]\nmax = [0.4, 0.6]\n[particles]\nspacing = 0.02\n" + fluid("0", "0.2", below) +
         fluid("0.2", "0.4", above) + more +
         "[walls]\nmethod = \"akinci2012\"\n[solver]\nname = \"" + solver + "\"\n[time]\n" + time;
}

/// Mean height of the particles of a liquid.
double height_of(const Simulation& sim, int liquid) {
  const ParticleView f = sim.fluid();
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    if (f.liquid_of(i) == liquid) {
      sum += double(f.x[2 * i + 1]);
      ++n;
    }
  return sum / n;
}

class Liquids : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!has_solver(parse_scene(tank(GetParam(), 1000, 500, "", "end = 1\nstep = 1e-4\n"), "t.toml")
                        .solver.name))
      GTEST_SKIP() << "not compiled in this build";
  }
};
INSTANTIATE_TEST_SUITE_P(All, Liquids,
                         ::testing::Values("wcsph", "delta_sph", "pcisph", "iisph", "dfsph", "pbf"),
                         [](const auto& solver) { return std::string(solver.param); });

constexpr const char* adaptive = "end = 1\nstep = \"adaptive\"\nstep_max = 0.002\n";

// The upper liquid has a tenth of the density. Both stay in place, and the floor bears their
// weight.
TEST_P(Liquids, StayLayered) {
  Simulation sim = simulation_of(tank(GetParam(), 1000, 100, "", adaptive), "cpu");
  ASSERT_EQ(2u, sim.scene().liquids().size());
  double floor = 0, asked = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() < 0.5) continue;
    floor -= sim.wall_forces()[2][1];
    ++asked;
  }
  EXPECT_NEAR(0.1, height_of(sim, 0), 0.005);
  EXPECT_NEAR(0.3, height_of(sim, 1), 0.01);
  const Statistics s = sim.statistics();
  EXPECT_LT(s.density_error_mean, 0.02);
  EXPECT_LT(s.speed_mean, 0.02 * std::sqrt(2 * 9.81 * 0.4));
  const double weight = 9.81 * 0.4 * 0.2 * (1000 + 100);
  EXPECT_NEAR(weight, floor / asked, 0.05 * weight);
  for (const Warning& warning : sim.warnings()) ADD_FAILURE() << warning.message;
}

// The liquids start side by side.
TEST_P(Liquids, HeavyLiquidRunsBelowTheLightOne) {
  Simulation sim = simulation_of(
      std::string("[domain]\nmax = [0.6, 0.4]\n[particles]\nspacing = 0.02\n[[fluid]]\nmin = [0, "
                  "0]\nmax = [0.3, 0.3]\nrest_density = 300\n[[fluid]]\nmin = [0.3, 0]\nmax = "
                  "[0.6, 0.3]\n[walls]\nslip = \"free_slip\"\n[solver]\nname = \"") +
          GetParam() + "\"\n[time]\nend = 0.6\nstep = \"adaptive\"\nstep_max = 0.002\n",
      "cpu");
  const int light = 0, heavy = 1;
  while (!sim.finished()) sim.step();
  EXPECT_GT(height_of(sim, light), height_of(sim, heavy) + 0.08);
}

// Forces between two liquids of different masses are equal and opposite.
TEST_P(Liquids, ConserveMomentum) {
  const std::string name = GetParam();
  const bool weakly = name == "wcsph" || name == "delta_sph";
  Simulation sim = simulation_of(
      std::string("[domain]\nmin = [-3, -3]\nmax = [5, 5]\ngravity = [0, 0]\n[particles]\n"
                  "spacing = 0.05\njitter = 0.01\n[[fluid]]\nmin = [0.4, 0.6]\nmax = [0.9, "
                  "1.2]\nvelocity = [1.5, "
                  "0.2]\nrest_density = 200\n[[fluid]]\nmin = [1.0, 0.7]\nmax = [1.5, 1.2]\n"
                  "velocity = [-1, -0.3]\n[walls]\nmethod = \"open\"\n[solver]\nname = \"") +
          GetParam() +
          (weakly ? "\"\nsound_speed = 30\n[time]\nend = 0.1\nstep = 0.0001\n"
                  : "\"\n[time]\nend = 0.2\nstep = 0.002\n"),
      "cpu");
  const auto before = sim.statistics().momentum;
  double pressed = 0;
  while (!sim.finished()) {
    sim.step();
    for (const Real p : sim.fluid().pressure) pressed = std::max(pressed, double(p));
  }
  const auto after = sim.statistics().momentum;
  EXPECT_GT(pressed, 100) << "the liquids must collide";
  for (std::size_t d = 0; d < 2; ++d)
    EXPECT_NEAR(before[d], after[d], 3e-5 * 2.5 * (1000 * 0.25 + 200 * 0.3)) << d;
}

// Two liquids that differ in colour only have the bits of one liquid.
TEST_P(Liquids, OfEqualPropertiesHaveTheBitsOfOne) {
  const auto state = [&](const char* color) {
    std::string text = tank(GetParam(), 800, 800, color, "end = 1\nstep = 2e-4\n");
    if (std::string(GetParam()) == "delta_sph")
      text.insert(text.find("[time]"), "density_diffusion = \"antuono2010\"\n");
    Simulation sim = simulation_of(text, "cpu");
    for (int k = 0; k < 20; ++k) sim.step();
    return std::pair(sim.state_sha256(), sim.scene().liquids().size());
  };
  const char* one = "[[fluid]]\nmin = [0, 0.5]\nmax = [0.1, 0.55]\nrest_density = 800\n";
  const char* two =
      "[[fluid]]\nmin = [0, 0.5]\nmax = [0.1, 0.55]\nrest_density = 800\ncolor = \"#ff0000\"\n";
  EXPECT_EQ(1u, state(one).second);
  EXPECT_EQ(2u, state(two).second);
  EXPECT_EQ(state(one).first, state(two).first);
}

TEST_P(Liquids, HaveTheSameBitsOnAnyThreadsAndAfterARestart) {
  const std::string text = tank(GetParam(), 1000, 150, "", adaptive);
  expect_same_bits(text, 20);
  expect_same_bits_after_restart(text, 10, 10);
}

}  // namespace
}  // namespace freshet::test

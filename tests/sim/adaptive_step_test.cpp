// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

std::string scene(const std::string& solver, const std::string& time) {
  return "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\n"
         "max = [0.5, 0.5]\n[solver]\n" +
         solver + "[time]\nend = 0.05\n" + time;
}

/// Runs to the end and checks each step against the limits. Returns how often each limit applied.
std::map<std::string, std::int64_t> run(const std::string& text, double step_max) {
  Simulation sim = simulation_of(text);
  double time = 0, least = INFINITY, most = 0;
  while (!sim.finished()) {
    const TimeStepBounds b = sim.bounds();
    EXPECT_GT(b.least(), 0);
    EXPECT_EQ(b.least(), std::min({b.acoustic, b.force, b.viscous}));
    const double before = sim.time();
    EXPECT_LT(before, sim.scene().time.end);
    sim.step();
    const double dt = sim.time_steps().last;
    EXPECT_EQ(dt, std::min(b.least(), step_max));
    time += dt;
    least = std::min(least, dt);
    most = std::max(most, dt);
  }
  EXPECT_EQ(time, sim.time());
  EXPECT_GE(sim.time(), sim.scene().time.end * (1 - 1e-12));
  EXPECT_EQ(least, sim.time_steps().min);
  EXPECT_EQ(most, sim.time_steps().max);
  std::int64_t steps = 0;
  for (const auto& [bound, count] : sim.time_steps().ruled) steps += count;
  EXPECT_EQ(sim.steps_done(), steps);
  return sim.time_steps().ruled;
}

using Ruled = std::map<std::string, std::int64_t>;

TEST(AdaptiveStep, IsTheMinimumOfItsLimits) {
  const std::string adaptive = "step = \"adaptive\"\n";
  const Ruled sound =
      run(scene("name = \"wcsph\"\nsound_speed = 30.0\n", adaptive + "step_max = 0.01\n"), 0.01);
  EXPECT_GT(sound.at("sound"), 50);
  const Ruled capped =
      run(scene("name = \"delta_sph\"\nsound_speed = 30.0\n", adaptive + "step_max = 0.0001\n"),
          0.0001);
  EXPECT_EQ((Ruled{{"step_max", 500}}), capped);
  const Ruled thick =
      run(scene("name = \"wcsph\"\nsound_speed = 30.0\nartificial_viscosity = 4.0\n",
                adaptive + "step_max = 0.01\n"),
          0.01);
  EXPECT_GT(thick.at("viscosity"), 50);
  const Ruled pushed =
      run(scene("name = \"mueller2003\"\nstiffness = 0.5\n", adaptive + "step_max = 0.1\n"), 0.1);
  EXPECT_GT(pushed.at("force"), 0);
}

TEST(AdaptiveStep, LimitsFollowTheFormulas) {
  Simulation sim = simulation_of(
      scene("name = \"wcsph\"\nsound_speed = 30.0\n", "step = \"adaptive\"\nstep_max = 0.01\n"));
  for (int k = 0; k < 20; ++k) sim.step();
  const TimeStepBounds b = sim.bounds();
  const double h = 0.05;  // half the support radius
  EXPECT_NEAR(0.4 * h / (30 + sim.statistics().speed_max), b.acoustic, 1e-8);
  EXPECT_NEAR(0.125 * h * h / (0.05 * h * 30 / 8), b.viscous, 1e-6);
  EXPECT_LT(b.force, 0.25 * std::sqrt(h / 9.81) * 1.01);
}

TEST(FixedStep, TimeIsAMultipleOfTheStep) {
  Simulation sim =
      simulation_of(scene("name = \"wcsph\"\nsound_speed = 30.0\n", "step = 0.0003\n"));
  while (!sim.finished()) {
    sim.step();
    EXPECT_EQ(double(sim.steps_done()) * 0.0003, sim.time());
  }
  EXPECT_EQ(167, sim.steps_done());
  EXPECT_EQ(0.0003, sim.time_steps().min);
  EXPECT_EQ(0.0003, sim.time_steps().max);
  EXPECT_TRUE(sim.time_steps().ruled.empty());
}

}  // namespace
}  // namespace freshet::test

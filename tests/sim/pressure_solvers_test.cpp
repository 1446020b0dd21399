// SPDX-License-Identifier: MIT
// Pressure solvers: still water stays at rest, momentum is conserved, and solves that do not
// converge are reported.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/select.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

constexpr const char* all_solvers[] = {"pcisph", "iisph", "dfsph", "pbf"};

std::string pool(const std::string& solver, const std::string& time,
                 const std::string& walls = "[walls]\nmethod = \"akinci2012\"\n") {
  return "[domain]\nmax = [0.5, 0.5]\n[particles]\nspacing = 0.025\n[fluid]\nmin = [0, 0]\n"
         "max = [0.5, 0.3]\npressure = \"hydrostatic\"\n" +
         walls + "[solver]\nname = \"" + solver + "\n[time]\n" + time;
}

class PressureSolver : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!has_solver(parse_scene(pool(name(), "end = 1\nstep = 0.1\n"), "pool.toml").solver.name))
      GTEST_SKIP() << "not compiled in this build";
  }
  std::string name(const std::string& more = "") const {
    return std::string(GetParam()) + "\"\n" + more;
  }
};
INSTANTIATE_TEST_SUITE_P(All, PressureSolver, ::testing::ValuesIn(all_solvers),
                         [](const auto& solver) { return std::string(solver.param); });

TEST_P(PressureSolver, KeepsStillWaterAtRest) {
  for (const char* walls :
       {"[walls]\nmethod = \"akinci2012\"\n", "[walls]\nmethod = \"ghost\"\n"}) {
    Simulation sim = simulation_of(pool(name(), "end = 5\nstep = 0.002\n", walls), "cpu");
    const double height = sim.statistics().height_mean;
    double worst = 0;
    while (!sim.finished()) {
      sim.step();
      worst = std::max(worst, sim.statistics().density_error_mean);
    }
    const Statistics s = sim.statistics();
    EXPECT_EQ(0, s.out_of_bounds) << walls;
    EXPECT_NEAR(height, s.height_mean, 0.01 * height) << walls;
    EXPECT_LT(s.speed_mean, 0.01 * std::sqrt(2 * 9.81 * 0.3)) << walls;  // of a fall by 0.3 m
    EXPECT_LT(s.density_error_mean, 1.5 * sim.solves().back().tolerance) << walls;
    EXPECT_LT(worst, 0.005) << walls;
    for (const SolveStatistics& solve : sim.solves()) EXPECT_EQ(0, solve.not_converged) << walls;
  }
}

TEST_P(PressureSolver, FloorBearsTheWeightOfTheWater) {
  Simulation sim = simulation_of(pool(name(), "end = 3\nstep = 0.002\n"), "cpu");
  double floor = 0, samples = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() < 2) continue;
    floor -= sim.wall_forces()[2][1];
    ++samples;
  }
  const double weight = 1000 * 0.5 * 0.3 * 9.81;
  EXPECT_NEAR(weight, floor / samples, 0.03 * weight);
}

TEST_P(PressureSolver, ConservesMomentum) {
  Simulation sim = simulation_of(
      "[domain]\nmin = [-3, -3]\nmax = [5, 5]\ngravity = [0, 0]\n[particles]\nspacing = 0.05\n"
      "jitter = 0.01\n[[fluid]]\nmin = [0.4, 0.6]\nmax = [0.9, 1.2]\nvelocity = [1.5, 0.2]\n"
      "[[fluid]]\nmin = [1.0, 0.7]\nmax = [1.5, 1.2]\nvelocity = [-1, -0.3]\n"
      "[walls]\nmethod = \"open\"\n[solver]\nname = \"" +
          name() + "[time]\nend = 0.2\nstep = 0.002\n",
      "cpu");
  const Statistics before = sim.statistics();
  double pressed = 0;
  while (!sim.finished()) {
    sim.step();
    for (const Real p : sim.fluid().pressure) pressed = std::max(pressed, double(p));
  }
  const Statistics after = sim.statistics();
  EXPECT_GT(pressed, 100) << "the blocks must collide";
  for (std::size_t d = 0; d < 2; ++d)
    EXPECT_NEAR(before.momentum[d], after.momentum[d], 2e-5 * 2.5 * 1000 * 0.55) << d;  // m |v|
  EXPECT_NEAR(before.angular_momentum[0], after.angular_momentum[0], 2e-4 * 2.5 * 1000 * 0.55);
}

// A ball of water falls in a hollow sphere and splashes; particles that separate must not gain
// energy.
TEST_P(PressureSolver, DoesNotGainEnergyInASplash) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1, 1, 1]\n[particles]\nspacing = 0.025\n[fluid]\nshape = \"sphere\"\n"
      "center = [0.5, 0.5, 0.5]\nradius = 0.15\n[[wall]]\nshape = \"sphere\"\nside = \"inside\"\n"
      "center = [0.5, 0.5, 0.5]\nradius = 0.45\n[solver]\nname = \"" +
          name() + "[time]\nend = 0.6\nstep = \"adaptive\"\nstep_max = 0.004\n",
      "cpu");
  const auto energy = [&] {
    const Statistics s = sim.statistics();
    return s.kinetic_energy + s.potential_energy;
  };
  const double start = energy();
  while (!sim.finished()) {
    sim.step();
    ASSERT_LT(energy(), 1.05 * start) << sim.time();
  }
}

// The density tolerance determines the pressure of a single step poorly, so the test averages over
// many. It compares the slope, since the pressure is not exactly 0 at the surface, where particles
// have few neighbours. Particles within two spacings of a wall do not count.
TEST_P(PressureSolver, HasTheSlopeOfHydrostaticPressure) {
  Simulation sim = simulation_of(pool(name(), "end = 2\nstep = 0.001\n"), "cpu");
  double n = 0, depths = 0, pressures = 0, depths2 = 0, products = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() < 1) continue;
    const ParticleView f = sim.fluid();
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double x = double(f.x[2 * i]), depth = 0.3 - double(f.x[2 * i + 1]);
      const double p = double(f.pressure[i]);
      if (depth < 0.05 || depth > 0.25 || x < 0.05 || x > 0.45) continue;
      ++n;
      depths += depth;
      pressures += p;
      depths2 += depth * depth;
      products += depth * p;
    }
  }
  const double slope = (n * products - depths * pressures) / (n * depths2 - depths * depths);
  EXPECT_NEAR(1, slope / (1000 * 9.81), 0.08);  // short supports overestimate: wcsph has 1.07
}

// Two iterations are too few for this collapse. The step is halved; if that does not help, it is
// accepted and a warning reports it.
TEST_P(PressureSolver, WarnsOfSolvesThatDidNotConverge) {
  const std::string hasty = "max_iterations = 2\ndensity_tolerance = 1e-6\n";
  Simulation sim = simulation_of(pool(name(hasty), "end = 0.1\nstep = 0.002\n"), "cpu");
  while (!sim.finished()) sim.step();
  EXPECT_NEAR(0.1, sim.time(), 1e-12);
  EXPECT_GT(sim.time_steps().retried, 0);
  EXPECT_GT(sim.solves().back().not_converged, 0);
  EXPECT_GT(sim.solves().back().worst_error, 1e-6);
  ASSERT_EQ(1u, sim.warnings().size());
  EXPECT_EQ("pressure solve", sim.warnings()[0].kind);
  for (const char* remedy : {"_tolerance", "solver.max_iterations"})
    EXPECT_NE(std::string::npos, sim.warnings()[0].message.find(remedy)) << remedy;
  EXPECT_LT(sim.statistics().density_error_mean, 0.05) << "the state must stay valid";
}

TEST_P(PressureSolver, DoesNotHalveStepsWithoutRetry) {
  const std::string hasty = "max_iterations = 2\ndensity_tolerance = 1e-6\n";
  Simulation sim =
      simulation_of(pool(name(hasty), "end = 0.1\nstep = 0.002\nretry = false\n"), "cpu");
  while (!sim.finished()) sim.step();
  EXPECT_EQ(0, sim.time_steps().retried);
  EXPECT_EQ(50, sim.solves().back().solves);
}

std::string column(const char* iteration, double depth) {
  return "[domain]\nmax = [0.2, 1.2]\n[particles]\nspacing = 0.02\n[fluid]\nmin = [0, 0]\n"
         "max = [0.2, " +
         std::to_string(depth) + "]\n[solver]\nname = \"dfsph\"\niteration = \"" + iteration +
         "\"\ndensity_correction = \"at_once\"\ndensity_tolerance = 1e-5\nmax_iterations = "
         "1000\n[time]\nend = 0.05\nstep = 0.001\n";
}
double iterations(const char* iteration, double depth) {
  Simulation sim = simulation_of(column(iteration, depth), "cpu");
  while (!sim.finished()) sim.step();
  EXPECT_EQ(0, sim.solves()[1].not_converged);
  return sim.solves()[1].mean_iterations();
}

// The water starts without pressure, which has to propagate from the floor to the surface.
TEST(Nesterov, NeedsHalfTheIterationsOfJacobiInADeepColumn) {
  const double deep = iterations("nesterov", 1.0), shallow = iterations("nesterov", 0.5);
  EXPECT_LT(deep, 0.5 * iterations("jacobi", 1.0));
  EXPECT_LT(deep, 2 * shallow) << "iterations must grow more slowly than the depth";
}

}  // namespace
}  // namespace freshet::test

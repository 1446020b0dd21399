// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/select.h"
#include "scene/model/expressions.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

class BodyForce : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
    if (!has_solver(parse_scene(scene("", 1), "test.toml").solver.name))
      GTEST_SKIP() << "not compiled in this build";
  }
  /// A block of water in an open domain, 1 m from the domain's centre.
  std::string scene(const std::string& domain, double end, double step = 0.0005) const {
    std::string text = "[domain]\nmax = [4, 4]\n" + domain +
                       "[particles]\nspacing = 0.05\n[fluid]\nmin = [2.8, 1.8]\nmax = [3.2, 2.2]\n"
                       "[walls]\nmethod = \"open\"\n[solver]\nname = \"" +
                       std::string(GetParam()) + "\"\n[time]\nend = " + std::to_string(end) +
                       "\nstep = " + std::to_string(step) + "\n";
    if (GetParam() == std::string("delta_sph"))
      text.insert(text.find("[time]"), "sound_speed = 30\ndensity_diffusion = \"antuono2010\"\n");
    return text;
  }
  /// Centre of mass of the fluid.
  static Vector center(const Simulation& sim) {
    const ParticleView f = sim.fluid();
    Vector sum(2);
    for (std::size_t i = 0; i < f.x.size(); ++i) sum[i % 2] += double(f.x[i]) / double(f.size());
    return sum;
  }
  static Simulation run(const std::string& text) {
    Simulation sim = simulation_of(text);
    while (!sim.finished()) sim.step();
    return sim;
  }
};
INSTANTIATE_TEST_SUITE_P(Solvers, BodyForce,
                         ::testing::Values("delta_sph", "iisph", "dfsph", "pbf"),
                         [](const auto& solver) { return std::string(solver.param); });

// Pair forces do not move the centre of mass, so it swings like a point mass.
TEST_P(BodyForce, MovesTheCentreOfMassLikeAPointMass) {
  const std::string domain = "gravity = [0, 0]\nbody_force = [\"-25*(x - 2)\", \"-25*(y - 2)\"]\n";
  const Simulation sim = run(scene(domain, 0.5, 0.001));
  EXPECT_NEAR(2 + std::cos(5 * 0.5), center(sim)[0], 0.01);
  EXPECT_NEAR(2, center(sim)[1], 0.002);
}

TEST_P(BodyForce, ThatIsConstantEqualsGravity) {
  const Simulation one = run(scene("gravity = [1, -9.81]\n", 0.2)),
                   other =
                       run(scene("gravity = [0, 0]\nbody_force = [\"1\", \"-(9 + 0.81)\"]\n", 0.2));
  for (std::size_t i = 0; i < one.fluid().x.size(); ++i)
    EXPECT_NEAR(double(one.fluid().x[i]), double(other.fluid().x[i]), 1e-3);
}

TEST_P(BodyForce, CanDependOnTime) {
  const std::string domain = "gravity = [0, 0]\nbody_force = [\"4*sin(10*t)\", \"4*cos(10*t)\"]\n";
  const double t = 0.3;
  const Simulation sim = run(scene(domain, t, 0.001));
  EXPECT_NEAR(3 + 0.04 * (10 * t - std::sin(10 * t)), center(sim)[0], 0.002);
  EXPECT_NEAR(2 + 0.04 * (1 - std::cos(10 * t)), center(sim)[1], 0.002);
}

TEST(BodyForceOrder, IsTheOrderOfTheIntegrator) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const auto error = [](const char* integrator, double step) {
    Simulation sim = simulation_of(
        "[domain]\nmax = [4, 4]\ngravity = [0, 0]\nbody_force = [\"-25*(x - 2)\", \"0\"]\n"
        "[particles]\nspacing = 0.2\n[fluid]\nshape = \"lattice\"\nfrom = [3, 2]\ncount = [1, 1]\n"
        "[walls]\nmethod = \"open\"\n[solver]\nname = \"wcsph\"\nsound_speed = 30\n[time]\nend = "
        "0.4\nintegrator = \"" +
        std::string(integrator) + "\"\nstep = " + std::to_string(step) + "\n");
    while (!sim.finished()) sim.step();
    return std::abs(double(sim.fluid().x[0]) - 2 - std::cos(5 * 0.4));
  };
  EXPECT_NEAR(2, error("symplectic_euler", 0.02) / error("symplectic_euler", 0.01), 0.2);
  for (const char* integrator : {"leapfrog", "verlet"})
    EXPECT_NEAR(4, error(integrator, 0.02) / error(integrator, 0.01), 0.4) << integrator;
}

TEST(BodyForceValue, ThatIsNaNIsReportedWithFunctionPlaceAndTime) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  Simulation sim = simulation_of(
      "[domain]\nmax = [4, 4]\ngravity = [0, 0]\nbody_force = [\"0\", \"t < 0.0035 ? 0 : "
      "sqrt(-x)\"]\n[particles]\nspacing = 0.2\n[fluid]\nshape = \"lattice\"\nfrom = [3, 2]\n"
      "count = [1, 1]\n[walls]\nmethod = \"open\"\n[solver]\nname = \"dfsph\"\n[time]\nend = "
      "0.01\nstep = 0.001\n");
  try {
    while (!sim.finished()) sim.step();
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_EQ(Error::Kind::run, e.kind());
    EXPECT_STREQ(
        "test.toml:4:14: error: domain.body_force is NaN at (3, 2), 0.004 s, in \"t < 0.0035 ? 0 : "
        "sqrt(-x)\"; fix the function",
        e.what());
    EXPECT_EQ(4, sim.steps_done());
  }
}

TEST(BodyForceOrder, LimitsAdaptiveSteps) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  Simulation sim = simulation_of(
      "[domain]\nmax = [4, 4]\ngravity = [0, 0]\nbody_force = [\"100*t\", \"0\"]\n"
      "[particles]\nspacing = 0.1\n[fluid]\nmin = [1, 1]\nmax = [2, 2]\n[walls]\nmethod = "
      "\"open\"\n[solver]\nname = \"dfsph\"\n[time]\nend = 1\nstep = \"adaptive\"\nstep_max = "
      "0.1\n");
  while (sim.time() < 0.5) sim.step();
  EXPECT_NEAR(0.25 * std::sqrt(0.1 / (100 * sim.time())), sim.bounds().force, 1e-6);
}

}  // namespace
}  // namespace freshet::test

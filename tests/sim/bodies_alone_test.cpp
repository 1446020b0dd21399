// SPDX-License-Identifier: MIT
// Scenes with bodies and no fluid.
#include <gtest/gtest.h>

#include "engine/select.h"
#include "freshet/simulation.h"
#include "scene/model/body_shape.h"

namespace freshet::test {
namespace {

std::string ball_over_box(bool flat, const char* solver, const char* time) {
  const std::string shapes =
      flat ? "domain.max = [2, 2]\nparticles.spacing = 0.1\n"
             "[[body]]\nname = \"ball\"\nshape = \"sphere\"\ncenter = [1, 1.5]\nradius = 0.2\n"
             "motion = \"free\"\ndensity = 20\nrestitution = 0\n"
             "[[body]]\nmin = [0.5, 0]\nmax = [1.5, 0.4]\n"
           : "domain.max = [2, 2, 2]\nparticles.spacing = 0.1\n"
             "[[body]]\nname = \"ball\"\nshape = \"sphere\"\ncenter = [1, 1.5, 1]\nradius = 0.2\n"
             "motion = \"free\"\ndensity = 20\nrestitution = 0\n"
             "[[body]]\nmin = [0.5, 0, 0.5]\nmax = [1.5, 0.4, 1.5]\n";
  return shapes + "[solver]\nname = \"" + solver + "\"\n[time]\nend = 1\n" + time;
}

TEST(BodiesAlone, FallAndComeToRest) {
  if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  for (const bool flat : {true, false})
    for (const auto& [solver, name] :
         {std::pair{"wcsph", SolverName::wcsph}, {"dfsph", SolverName::dfsph}})
      for (const char* time : {"step = 0.005\n", "step = \"adaptive\"\nstep_max = 0.005\n"}) {
        if (!has_solver(name)) continue;
        SCOPED_TRACE(std::string(solver) + " " + time + (flat ? " in 2D" : " in 3D"));
        const Scene scene = parse_scene(ball_over_box(flat, solver, time), "test.toml");
        EXPECT_TRUE(scene_warnings(scene).empty());
        Simulation sim(scene);
        while (!sim.finished()) sim.step();
        EXPECT_EQ(200, sim.steps_done()) << "no fluid limits the step";
        EXPECT_NEAR(0.6, sim.bodies()[0].position[1], 0.01);
        EXPECT_EQ(0, sim.bodies()[0].force[1]);
        EXPECT_TRUE(sim.warnings().empty());
        EXPECT_EQ(0, sim.statistics().particles);
        EXPECT_EQ(0, sim.statistics().density_mean);
      }
}

TEST(BodiesAlone, HaveTheSameBitsWithTheReferenceBackend) {
  if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  for (const bool flat : {true, false}) {
    std::string states[2];
    for (const char* backend : {"cpu", "reference"}) {
      const std::string scene = ball_over_box(flat, "wcsph", "step = 0.005\n");
      Simulation sim(parse_scene(scene, "test.toml", {{"solver.backend", backend}}));
      for (int k = 0; k < 100; ++k) sim.step();
      states[backend[0] == 'r'] = sim.state_sha256();
    }
    EXPECT_EQ(states[0], states[1]) << flat;
  }
}

// Fluid that the caller adds meets the bodies.
TEST(BodiesAlone, TakeFluidLater) {
  if (!has_solver(SolverName::wcsph)) GTEST_SKIP() << "not compiled in this build";
  Simulation sim(
      parse_scene("domain.max = [1, 1]\nparticles.spacing = 0.1\n"
                  "[[body]]\nmin = [0.3, 0]\nmax = [0.7, 0.4]\n"
                  "[solver]\nname = \"wcsph\"\n[time]\nend = 1\nstep = \"adaptive\"\n"
                  "step_max = 0.005\n",
                  "test.toml"));
  sim.step();
  EXPECT_EQ(0.005, sim.time_steps().last);
  const std::vector<Real> x{Real(0.5), Real(0.55)};
  sim.add_particles(x);
  sim.step();
  EXPECT_LT(sim.time_steps().last, 0.005) << "the speed of sound limits the step";
  while (sim.time() < 0.5) sim.step();
  ASSERT_EQ(1u, sim.fluid().size());
  EXPECT_GT(double(sim.fluid().x[1]), 0.35) << "it lies on the body";
}

}  // namespace
}  // namespace freshet::test

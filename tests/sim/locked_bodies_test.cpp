// SPDX-License-Identifier: MIT
// Bodies with locked axes in a fluid.
#include <gtest/gtest.h>

#include "engine/select.h"
#include "freshet/simulation.h"
#include "scene/model/body_shape.h"

namespace freshet::test {
namespace {

/// A column of water that falls against a box, which can rise and sink only.
Simulation dam_and_box(const char* solver, bool flat) {
  const std::string tables =
      flat ? "domain.max = [1, 0.6]\nparticles.spacing = 0.03\n"
             "[fluid]\nmin = [0, 0]\nmax = [0.3, 0.6]\n"
             "[body]\nmin = [0.33, 0.2]\nmax = [0.51, 0.35]\nlock = [\"x\", \"rotation_z\"]\n"
           : "domain.max = [1, 0.6, 0.3]\nparticles.spacing = 0.05\n"
             "[fluid]\nmin = [0, 0, 0]\nmax = [0.3, 0.6, 0.3]\n"
             "[body]\nmin = [0.35, 0.2, 0.05]\nmax = [0.55, 0.35, 0.2]\n"
             "lock = [\"x\", \"rotation_x\", \"z\", \"rotation_z\", \"rotation_y\"]\n";
  return Simulation(parse_scene(tables + "motion = \"free\"\ndensity = 400\n[solver]\nname = \"" +
                                    solver +
                                    "\"\n[time]\nend = 1\nstep = \"adaptive\"\nstep_max = 0.002\n",
                                "test.toml"));
}

TEST(LockedBodies, KeepTheBitsOfTheirCoordinatesInAFluid) {
  if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  for (const bool flat : {true, false})
    for (const auto& [solver, name] :
         {std::pair{"wcsph", SolverName::wcsph}, {"dfsph", SolverName::dfsph}}) {
      if (!has_solver(name)) continue;
      SCOPED_TRACE(std::string(solver) + (flat ? " in 2D" : " in 3D"));
      Simulation sim = dam_and_box(solver, flat);
      const BodyState before = sim.bodies()[0];
      double pushed = 0;
      while (sim.time() < 0.15) {
        sim.step();
        pushed = std::max(pushed, sim.bodies()[0].force[0]);
      }
      const BodyState after = sim.bodies()[0];
      EXPECT_GT(pushed, 1) << "the water reached the box";
      EXPECT_EQ(before.position[0], after.position[0]);
      EXPECT_EQ(before.position[2], after.position[2]);
      EXPECT_EQ(before.orientation, after.orientation);
      EXPECT_LT(after.position[1], before.position[1] - 0.05) << "it falls";
    }
}

}  // namespace
}  // namespace freshet::test

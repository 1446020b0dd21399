// SPDX-License-Identifier: MIT
// Recorded states, to the bit. A change of a solver must not change them unnoticed. The states of
// the article and of Müller's paper are in article_golden_test.cpp.
#include <gtest/gtest.h>

#include "freshet/simulation.h"

namespace freshet {
namespace {

#ifndef FRESHET_DOUBLE

std::string state_after(const char* scene, int steps) {
  Simulation sim(parse_scene(scene, "golden"));
  for (int k = 0; k < steps; ++k) sim.step();
  return sim.state_sha256();
}

TEST(Golden, WcsphIn3DHasTheRecordedState) {
  EXPECT_EQ("3b598812ee3c10d26053980ffc17271e8388cfca90cf4f84ec84b16bfd20c78a", state_after(R"(
domain = { max = [1, 1, 0.6] }
particles = { spacing = 0.1, support_radius = 0.2154 }
solver = { name = "wcsph" }
walls = { method = "akinci2012", z_max = "ghost" }
time = { end = 1, step = 0.0005 }
fluid = { min = [0, 0, 0], max = [0.5, 0.8, 0.6] }
)",
                                                                                            200));
}

TEST(Golden, DeltaSphIn2DHasTheRecordedState) {
  EXPECT_EQ("39fba3b67b09b44945d470d819ba6a6db88d9b90649f31406c2cce79de56844d", state_after(R"(
domain = { max = [1, 1] }
particles = { spacing = 0.04, support_radius = 0.12 }
solver = { name = "delta_sph", kernel = "wendland_c2" }
walls = { method = "adami2012" }
time = { end = 1, step = "adaptive", step_max = 0.001 }
fluid = { min = [0, 0], max = [0.48, 0.8], pressure = "hydrostatic" }
)",
                                                                                            200));
}

TEST(Golden, PeriodicAntuonoIn2DHasTheRecordedState) {
  EXPECT_EQ("7d03f778bce151003fd47ca26de9cc854fdff04c98023086ab558ea835ad3974", state_after(R"(
domain = { max = [1, 1], gravity = [0, 0], periodic = "xy" }
particles = { spacing = 0.05, support_radius = 0.15, jitter = 0.01 }
solver.name = "delta_sph"
solver.kernel = "wendland_c4"
solver.density_diffusion = "antuono2010"
solver.sound_speed = 10
time = { end = 1, step = 0.001, integrator = "verlet" }
fluid = [ { min = [0, 0], max = [1, 0.5], velocity = [1, 0] },
          { min = [0, 0.5], max = [1, 1], velocity = [-1, 0] } ]
)",
                                                                                            100));
}

#endif

}  // namespace
}  // namespace freshet

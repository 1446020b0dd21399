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
  EXPECT_EQ("66e71199b75db23860abf49b48e3a5b4759380c67cb9c3a71108a1a3b63292ae", state_after(R"(
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
  EXPECT_EQ("d3e273832c2f5cb85a48fe2f2b9d4abd0c62f460ea82961d89f6523eed33d4e8", state_after(R"(
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
  EXPECT_EQ("d404a4fcf4b69c5665ba07266ad30c2099dca78aa00c3c7928ee86649f53185c", state_after(R"(
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

// SPDX-License-Identifier: MIT
// The load of the fluid on the surfaces of walls and bodies.
#include "sim/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scene/model/expressions.h"
#include "sim/forced.h"

namespace freshet::test {
namespace {

/// The sum of traction times area over each part.
std::map<int, Vector> sums_of(const SurfacePoints& surface) {
  const auto D = std::size_t(surface.dimension);
  std::map<int, Vector> sums;
  for (std::size_t k = 0; k < surface.size(); ++k) {
    Vector& sum = sums.try_emplace(surface.part[k], Vector(D, 0.0)).first->second;
    for (std::size_t d = 0; d < D; ++d) sum[d] += surface.area * surface.traction[D * k + d];
  }
  return sums;
}

/// A basin with walls of this method, and a ball and a turned plate in it.
std::string basin(const std::string& solver, const std::string& walls) {
  return "[domain]\nmax = [0.8, 0.6, 0.8]\nperiodic = \"z\"\n[particles]\nspacing = "
         "0.05\n[fluid]\nmin = [0, 0, 0]\nmax = [0.8, 0.4, 0.8]\n[[wall]]\nname = "
         "\"bump\"\nshape = \"sphere\"\ncenter = [0.2, 0.0, 0.4]\nradius = 0.15\n[[body]]\nname = "
         "\"ball\"\nshape = \"sphere\"\ncenter = [0.55, 0.2, 0.05]\nradius = 0.12\nmotion = "
         "\"moved\"\nangle = \"720*t\"\n[walls]\nmethod = \"" +
         walls + "\"\n[solver]\nname = \"" + solver +
         "\"\nsound_speed = 30\n[time]\nend = 1\nstep = 0.0005\n";
}

class SurfacesOf : public ::testing::TestWithParam<const char*> {
  void SetUp() override {
    if (!compiled("delta_sph")) GTEST_SKIP() << "not compiled in this build";
    if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  }
};

TEST_P(SurfacesOf, AddUpToTheForcesOnAllParts) {
  Simulation sim = simulation_of(basin("delta_sph", GetParam()));
  for (int k = 0; k < 60; ++k) sim.step();
  const BoundaryForces boundary = sim.boundary_forces();
  const SurfacePoints surface = Surfaces(sim.scene()).load(boundary, sim.bodies());
  const auto parts = forces_on_parts(sim.scene(), boundary);
  const auto walls = sim.wall_forces();
  const auto sums = sums_of(surface);
  ASSERT_EQ(6u + 1 + 1, parts.size());
  double largest = 0;
  for (const Vector& force : parts)
    for (const double f : force) largest = std::max(largest, std::abs(f));
  EXPECT_GT(largest, 10);
  for (const auto& [part, sum] : sums)
    for (std::size_t d = 0; d < 3; ++d) {
      const auto p = std::size_t(part);
      EXPECT_NEAR(parts[p][d], sum[d], 1e-5 * largest) << "part " << part;
      if (p < walls.size()) {
        EXPECT_NEAR(walls[p][d], sum[d], 1e-5 * largest);
      }
    }
  EXPECT_TRUE(sums.contains(2) && sums.contains(6) && sums.contains(7));
}

TEST_P(SurfacesOf, LieOnTheWallsAndTheBodies) {
  Simulation sim = simulation_of(basin("delta_sph", GetParam()));
  for (int k = 0; k < 10; ++k) sim.step();
  const SurfacePoints surface = Surfaces(sim.scene()).load(sim.boundary_forces(), sim.bodies());
  std::map<int, int> count;
  for (std::size_t k = 0; k < surface.size(); ++k) {
    const float* x = &surface.x[3 * k];
    const float* n = &surface.normal[3 * k];
    EXPECT_NEAR(1, std::hypot(n[0], n[1], n[2]), 1e-5);
    const int part = surface.part[k];
    ++count[part];
    if (part == 2) {  // y_min
      EXPECT_EQ(0, x[1]);
      EXPECT_EQ(1, n[1]);
    }
    if (part == 6) {
      EXPECT_NEAR(0.15, std::hypot(x[0] - 0.2, x[1], x[2] - 0.4), 1e-5);
    }
    if (part == 7) {  // across the periodic end
      const double z = std::remainder(x[2] - 0.05, 0.8);
      EXPECT_NEAR(0.12, std::hypot(x[0] - 0.55, x[1] - 0.2, z), 1e-5);
      EXPECT_NEAR(n[2], z / 0.12, 1e-4);
    }
  }
  EXPECT_EQ(0, count[4]) << "a periodic side has no surface";
  // a point for each square spacing of the ball, more or less
  EXPECT_NEAR(1, count[7] * 0.0025 / (4 * 3.14159 * 0.0144), 0.4);
}

INSTANTIATE_TEST_SUITE_P(Walls, SurfacesOf, ::testing::Values("akinci2012", "adami2012"));

}  // namespace
}  // namespace freshet::test

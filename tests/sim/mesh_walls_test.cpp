// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/files.h"
#include "engine/select.h"
#include "mesh/meshes.h"
#include "scene/model/setup.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

class MeshWalls : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!reads_meshes()) GTEST_SKIP() << "built without Assimp";
    write_text(folder_ / "ball.stl", stl_of(ball_mesh(1, 4)));
  }
  /// A ball of water inside a hollow ball; both are meshes.
  std::string scene(const std::string& time) const {
    const std::string ball = "shape = \"mesh\"\nfile = \"" + (folder_ / "ball.stl").string() +
                             "\"\ntranslation = [0.5, 0.5, 0.5]\nscale = ";
    return "[domain]\nmax = [1, 1, 1]\n[particles]\nspacing = 0.03\n[fluid]\n" + ball +
           "0.15\n[[wall]]\nname = \"hollow\"\nside = \"inside\"\n" + ball +
           "0.45\n[solver]\nname = \"" + GetParam() + "\"\n[time]\n" + time;
  }
  TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Solvers, MeshWalls, ::testing::Values("wcsph", "dfsph"),
                         [](const auto& solver) { return std::string(solver.param); });

TEST_P(MeshWalls, HoldFallingWater) {
  Simulation sim =
      simulation_of(scene("end = 0.5\nstep = \"adaptive\"\nstep_max = 0.002\n"), "cpu");
  double farthest = 0;
  Vector most(3);
  while (!sim.finished()) {
    sim.step();
    const ParticleView f = sim.fluid();
    for (std::size_t i = 0; i < f.size(); ++i)
      farthest =
          std::max(farthest, norm(Point{double(f.x[3 * i]) - 0.5, double(f.x[3 * i + 1]) - 0.5,
                                        double(f.x[3 * i + 2]) - 0.5}));
    most = sim.wall_forces()[6];
  }
  EXPECT_GT(farthest, 0.4) << "the water must fall";
  EXPECT_LT(farthest, 0.45 + 0.015) << "a particle is more than half a spacing beyond the wall";
  EXPECT_LT(most[1], 0) << "the wall must bear the water";
}

TEST_P(MeshWalls, AreSampledEvenlyAndExcludeNoWater) {
  const Scene hollow = parse_scene(scene("end = 1\nstep = 0.001\n"), "mesh.toml");
  const Sample start = sample(hollow);
  const double volume = 4.0 / 3 * 3.14159 * 0.15 * 0.15 * 0.15;
  EXPECT_NEAR(volume, double(start.x.size() / 3) * 0.03 * 0.03 * 0.03, 0.06 * volume);
  EXPECT_EQ(0, start.left_out);
  const auto per_area = [](const WallSample& walls) {  // of spacing^2, in the middle of the layers
    return double(std::count(walls.wall.begin(), walls.wall.end(), 6)) * 0.03 * 0.03 /
           (4 * 3.14159 * 0.48 * 0.48);
  };
  if (hollow.method().walls == WallMethod::adami2012)
    EXPECT_NEAR(2, per_area(start.adami2012), 0.15);
  else EXPECT_NEAR(1.25, per_area(start.akinci2012), 0.15);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Reflecting walls hold water where the nearest face of a wall is not the one that it came from: at
// the end of a wall on the floor, and at the seam of two walls.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "engine/select.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// Reflecting walls have no density. Particles of wcsph meet there, and in half of the starts the
/// water gains energy after 1.3 s. Not even then do they pass.
std::string with_solver(const std::string& scene, const std::string& solver) {
  return scene + "[walls]\nmethod = \"reflection\"\n[time]\nend = 1.5\nstep = \"adaptive\"\n" +
         "step_max = 0.005\n[solver]\nname = \"" + solver + "\"\n[checks]\nwhen_wrong = \"warn\"\n";
}

/// The greatest number of particles behind the walls at any step.
int most_behind(const std::string& scene, const std::function<bool(Real x, Real y)>& is_behind) {
  Simulation sim = simulation_of(scene, "cpu", {1, ""});
  int most = 0;
  while (!sim.finished()) {
    sim.step();
    const ParticleView f = sim.fluid();
    int behind = 0;
    for (std::size_t i = 0; i < f.size(); ++i) behind += is_behind(f.x[2 * i], f.x[2 * i + 1]);
    most = std::max(most, behind);
  }
  return most;
}

class ReflectingWalls : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!has_solver(parse_scene(with_solver("domain.max = [1, 1]\nparticles.spacing = 0.1\n"
                                            "fluid = { min = [0, 0], max = [1, 1] }\n",
                                            GetParam()),
                                "test.toml")
                        .solver.name))
      GTEST_SKIP() << "not compiled in this build";
  }
};

TEST_P(ReflectingWalls, HoldCalmWaterAtTheirEndOnTheFloor) {
  const std::string scene =
      "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.04\n[fluid]\nmin = [0.0, 0.0]\n"
      "max = [0.48, 0.6]\n[[wall]]\nmin = [0.52, 0]\nmax = [0.6, 1]\nmethod = \"reflection\"\n";
  EXPECT_EQ(0, most_behind(with_solver(scene, GetParam()), [](Real x, Real) { return x > 0.53f; }));
}

TEST_P(ReflectingWalls, HoldSloshingWaterAtTheSeamOfTwo) {
  const std::string scene =
      "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.04\n[fluid]\nmin = [0.0, 0.32]\n"
      "max = [0.6, 0.72]\n[[wall]]\nmin = [0.0, 0.16]\nmax = [0.5, 0.32]\nmethod = \"reflection\"\n"
      "[[wall]]\nmin = [0.5, 0.16]\nmax = [1.0, 0.32]\nmethod = \"reflection\"\n";
  EXPECT_EQ(0, most_behind(with_solver(scene, GetParam()), [](Real, Real y) { return y < 0.31f; }));
}

INSTANTIATE_TEST_SUITE_P(Solvers, ReflectingWalls,
                         ::testing::Values("wcsph", "delta_sph", "dfsph", "pbf"));

}  // namespace
}  // namespace freshet::test

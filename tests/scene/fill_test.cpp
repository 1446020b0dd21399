// SPDX-License-Identifier: MIT
// Fluids fill their shapes up to walls that the lattice does not fit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

constexpr double pi = std::numbers::pi;

Scene round_tank(const std::string& solver = "dfsph") {
  return parse_scene(
      "[domain]\nmin = [-0.15, 0, -0.15]\nmax = [0.15, 0.4, 0.15]\n"
      "[particles]\nspacing = 0.02\n"
      "[fluid]\nshape = \"cylinder\"\ncenter = [0, 0.1, 0]\nradius = 0.1\nlength = 0.2\n"
      "[[wall]]\nshape = \"cylinder\"\nside = \"inside\"\ncenter = [0, 0.2, 0]\n"
      "radius = 0.1\nlength = 0.4\n[solver]\nname = \"" +
          solver + "\"\n[time]\nend = 0.1\nstep = \"adaptive\"\nstep_max = 0.004\n",
      "tank.toml");
}

void expect_full(const Scene& scene, double volume) {
  const Derived d = derive(scene);
  ASSERT_TRUE(d.fluids[0].asked);
  EXPECT_NEAR(volume, *d.fluids[0].asked, 0.002 * volume);
  EXPECT_NEAR(volume, d.fluids[0].filled, 0.01 * volume);
  const Sample s = sample(scene);
  const auto dimension = std::size_t(scene.dimension());
  EXPECT_EQ(d.particles, double(s.x.size() / dimension));
  EXPECT_EQ(s.x.size(), s.v.size());
  EXPECT_GT(nearest_distances(s.x, dimension).first, 0.6 * d.spacing);
}

TEST(Fill, ReachesTheWallOfARoundTank) {
  expect_full(round_tank(), pi * 0.1 * 0.1 * 0.2);
  const Sample s = sample(round_tank());
  for (std::size_t i = 0; i < s.x.size(); i += 3) {
    EXPECT_LT(std::hypot(s.x[i], s.x[i + 2]), 0.1 - 0.29 * 0.02);
    EXPECT_GT(s.x[i + 1], 0.29 * 0.02);
  }
}

TEST(Fill, ReachesASlopeAndADisc) {
  expect_full(scene_with("[1, 1]", 0.025,
                         "solver.name = \"dfsph\"\n[fluid]\nmin = [0, 0]\nmax = [1, 0.8]\n"
                         "[[wall]]\nshape = \"plane\"\npoint = [0.5, 0]\nnormal = [-1, 2]\n"
                         "[[wall]]\nshape = \"sphere\"\ncenter = [0.31, 0.47]\nradius = 0.11\n"),
              0.8 - 0.5 * 0.5 * 0.25 - pi * 0.11 * 0.11);
}

TEST(Fill, ReachesBodies) {
  expect_full(scene_with("[1, 0.8]", 0.0125,
                         "solver.name = \"dfsph\"\n[fluid]\nmin = [0, 0]\nmax = [1, 0.5]\n"
                         "[[body]]\nshape = \"sphere\"\ncenter = [0.7, 0.3]\nradius = 0.12\n"),
              0.5 - pi * 0.12 * 0.12);
  expect_full(scene_with("[1, 0.8, 0.6]", 0.04,
                         "solver.name = \"dfsph\"\n[fluid]\nmin = [0, 0, 0]\nmax = [1, 0.6, 0.6]\n"
                         "[[body]]\nshape = \"sphere\"\ncenter = [0.5, 0.3, 0.3]\nradius = 0.13\n"
                         "motion = \"free\"\ndensity = 600\n"),
              0.36 - 4 * pi / 3 * 0.13 * 0.13 * 0.13);
}

/// Places that are added around small bodies start up to 36 % too dense: the water burst at 9 m/s.
TEST(Fill, LeavesWaterAroundBodiesCalm) {
  for (const char* body : {"min = [0.41, 0.16]\nmax = [0.62, 0.33]\n",
                           "shape = \"sphere\"\ncenter = [0.5, 0.25]\nradius = 0.12\n"})
    for (const char* spacing : {"0.05", "0.025"}) {
      SCOPED_TRACE(std::string(body) + spacing);
      Simulation sim(
          parse_scene(std::string("[domain]\nmax = [1, 0.8]\n[particles]\nspacing = ") + spacing +
                          "\n[fluid]\nmin = [0, 0]\nmax = [1, 0.5]\npressure = "
                          "\"hydrostatic\"\n[[body]]\n" +
                          body +
                          "[solver]\nname = \"dfsph\"\n[time]\nend = 1\nstep = \"adaptive\"\n"
                          "step_max = 0.002\n",
                      "fill.toml"),
          {});
      double fastest = 0;
      while (sim.time() < 0.03) {
        sim.step();
        fastest = std::max(fastest, sim.statistics().speed_max);
      }
      EXPECT_LT(fastest, 1);
    }
}

// Beside the box and above it, a layer of places is too near.
TEST(Fill, ReachesABoxThatTheLatticeDoesNotFit) {
  expect_full(scene_with("[1, 1]", 0.05,
                         "solver.name = \"dfsph\"\n[fluid]\nmin = [0, 0]\nmax = [1, 0.8]\n"
                         "[[wall]]\nmin = [0.62, 0]\nmax = [1, 0.33]\n"),
              0.8 - 0.38 * 0.33);
}

TEST(Fill, LeavesPlacesAloneThatFit) {
  const auto with = [](const char* wall) {
    return sample(scene_with("[1, 1]", 0.05,
                             std::string("solver.name = \"dfsph\"\n[fluid]\nmin = [0, 0]\n"
                                         "max = [1, 0.8]\n") +
                                 wall));
  };
  const Sample cut = with("[[wall]]\nmin = [0.6, 0]\nmax = [1, 0.3]\n"), whole = with("");
  ASSERT_EQ(20u * 16, whole.density.size());
  EXPECT_EQ(20u * 16 - 8 * 6, cut.density.size());
  std::size_t j = 0;  // the places of the cut lattice are places of the whole one
  for (std::size_t i = 0; i < cut.x.size(); i += 2, j += 2) {
    while (j < whole.x.size() && (whole.x[j] != cut.x[i] || whole.x[j + 1] != cut.x[i + 1])) j += 2;
    ASSERT_LT(j, whole.x.size());
  }
}

// The last 9 mm of the height are less than half a spacing.
TEST(Fill, WarnsOfASpacingThatDoesNotDivideABox) {
  const auto warnings = [](const char* height) {
    return scene_warnings(scene_with(
        "[1, 1]", 0.02,
        fmt::format("solver.name = \"dfsph\"\n[fluid]\nmin = [0, 0]\nmax = [1, {}]\n", height)));
  };
  EXPECT_TRUE(warnings("0.2").empty());
  ASSERT_EQ(1u, warnings("0.209").size());
  EXPECT_NE(std::string::npos,
            warnings("0.209")[0].message.find("fill 0.2 m², 4.3 % less than the 0.209 m²"))
      << warnings("0.209")[0].message;
}

/// The first steps do not burst: they are slower than a fall through a spacing.
TEST(Fill, IsCalmInTheFirstSteps) {
  for (const char* solver : {"dfsph", "delta_sph"}) {
    Simulation sim(round_tank(solver), {});
    while (sim.time() < 0.02) sim.step();
    const Statistics now = sim.statistics();
    EXPECT_LT(now.density_error_mean, 0.01) << solver;
    EXPECT_LT(now.speed_mean, 0.2) << solver;
    EXPECT_LT(now.speed_max, std::sqrt(2 * 9.81 * 0.02)) << solver;
  }
}

}  // namespace
}  // namespace freshet::test

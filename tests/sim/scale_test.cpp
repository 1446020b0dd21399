// SPDX-License-Identifier: MIT
// A still tank of any size: its results scale with the spacing, or the scene is rejected.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/select.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// Water, 8 spacings deep, that starts without pressure. Froude and Reynolds numbers do not depend
/// on the spacing.
std::string tank(const std::string& solver, int dimension, double spacing) {
  const auto corner = [&](double x, double y) {
    return dimension == 2 ? fmt::format("[{}, {}]", x * spacing, y * spacing)
                          : fmt::format("[{}, {}, {}]", x * spacing, y * spacing, x * spacing);
  };
  const double size = spacing / 0.01;
  const bool sound = solver == "wcsph" || solver == "delta_sph";
  const bool mueller = solver == "mueller2003";  // thin: it boils later, and no bit may differ then
  const double viscosity = (mueller ? 5 : 0.02) * std::pow(size, 1.5);
  return fmt::format(
      "[domain]\nmax = {}\n[particles]\nspacing = {}\n[fluid]\nmin = {}\nmax = {}\n{}\n"
      "[solver]\nname = \"{}\"\n[time]\nend = {}\nstep = \"adaptive\"\nstep_max = {}\n",
      corner(8, 12), spacing, corner(0, 0), corner(8, 8),
      sound ? "" : fmt::format("viscosity = {}", viscosity), solver,
      (mueller ? 0.03 : 0.15) * std::sqrt(size), 0.002 * std::sqrt(size));
}

/// The results of a tank, each over its scale [1].
struct Result {
  double pressure, speed, height, steps;
};
Result run(const std::string& text, double spacing) {
  Simulation sim = simulation_of(text, "cpu", {1, ""});
  double pressure = 0, looks = 0;
  while (!sim.finished()) {
    sim.step();
    const ParticleView f = sim.fluid();
    for (const Real p : f.pressure) pressure += double(p) / double(f.size());
    ++looks;
  }
  const Statistics s = sim.statistics();
  return {pressure / looks / (1000 * 9.81 * 8 * spacing),
          s.speed_mean / std::sqrt(9.81 * 8 * spacing), s.height_mean / (8 * spacing),
          double(sim.steps_done())};
}

/// Spacings that are powers of 4, so that they, square roots and squares are scaled without
/// rounding.
constexpr double spacing_of(int k) {
  return 0.01 * (k < 0 ? 1.0 / double(1 << -2 * k) : double(1 << 2 * k));
}

class Scale : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, Scale,
                         ::testing::Values("mueller2003", "wcsph", "delta_sph", "pcisph", "iisph",
                                           "dfsph", "pbf"),
                         [](const auto& solver) { return std::string(solver.param); });

// From 0.15 micrometres to 168 km.
TEST_P(Scale, ResultsScaleOrTheSceneIsRejected) {
  const std::string solver = GetParam();
  if (!has_solver(parse_scene(tank(solver, 2, 0.01), "").solver.name))
    GTEST_SKIP() << "not compiled in this build";
  for (const int dimension : {2, 3}) {
    const Result right = run(tank(solver, dimension, 0.01), 0.01);
    if (solver != "mueller2003") {
      EXPECT_GT(right.pressure, 0.25) << "half a tank's depth, less what the start lacks";
    }
    int ran = 0;
    for (int k = -8; k <= 12; ++k) {
      const double spacing = spacing_of(k);
      SCOPED_TRACE(fmt::format("{} in {}D at {:.3g} m", solver, dimension, spacing));
      const std::string text = tank(solver, dimension, spacing);
      try {
        parse_scene(text, "tank.toml");
      } catch (const Error& e) {
        const std::string what = e.what();
        EXPECT_NE(what.find(fmt::format("a spacing of {:.4g} m", spacing)), what.npos) << what;
        EXPECT_NE(what.find(solver), what.npos) << what;
        EXPECT_NE(what.find(spacing < 1 ? "make both larger" : "make both smaller"), what.npos);
        continue;
      }
      const Result here = run(text, spacing);
      EXPECT_NEAR(right.pressure, here.pressure, 1e-3);
      EXPECT_NEAR(right.speed, here.speed, std::max(1e-3, 0.005 * right.speed));
      EXPECT_NEAR(right.height, here.height, 1e-4);
      EXPECT_EQ(right.steps, here.steps);
      ++ran;
    }
    EXPECT_GT(ran, 8);
  }
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Probes in a fluid with known fields.
#include "sim/probes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "scene/model/expressions.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// A block of 1 m × 0.6 m at rest density, whose velocity is (y, 0).
std::string block(const std::string& probe, const std::string& more = "") {
  return "[domain]\nmax = [2.0, 1.0]\ngravity = [0, 0]\n" + more +
         "[particles]\nspacing = 0.02\n[fluid]\nmin = [0, 0]\nmax = [1, 0.6]\nvelocity_field = "
         "[\"y\", \"0\"]\n" +
         probe +
         "[walls]\nmethod = \"reflection\"\n[solver]\nname = \"wcsph\"\nsound_speed = "
         "10\n[time]\nend = 1\nstep = "
         "1e-4\n";
}

/// The numbers of the last line of the first probe.
std::vector<double> look(const std::string& scene) {
  Simulation sim = simulation_of(scene);
  const auto lines = Probes(sim.scene()).look(sim);
  std::istringstream in(lines.at(0).substr(lines[0].rfind('\n', lines[0].size() - 2) + 1));
  std::vector<double> numbers;
  for (std::string word; std::getline(in, word, ',');) numbers.push_back(std::stod(word));
  return numbers;
}

TEST(Probes, InterpolateAtAPoint) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const auto inside = look(block("[probe]\nat = [0.5, 0.3]\n"));  // t, x, y, fraction, v, rho, p
  ASSERT_EQ(8u, inside.size());
  EXPECT_EQ(0, inside[0]);
  EXPECT_NEAR(1, inside[3], 0.02);
  EXPECT_NEAR(0.3, inside[4], 1e-3) << "a linear field must be interpolated exactly";
  EXPECT_NEAR(0, inside[5], 1e-9);
  EXPECT_NEAR(1000, inside[6], 1);
  const auto edge = look(block("[probe]\nat = [0.5, 0.6]\n"));
  EXPECT_NEAR(0.5, edge[3], 0.05);
  const auto outside = look(block("[probe]\nat = [1.5, 0.3]\n"));
  EXPECT_EQ(0, outside[3]);
  EXPECT_TRUE(std::isnan(outside[6])) << "the density must be NaN outside the fluid";
}

TEST(Probes, FindTheSurface) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const auto up = look(block("[probe]\nkind = \"surface\"\nfrom = [0.5, 0]\nto = [0.5, 1]\n"));
  EXPECT_NEAR(0.6, up[1], 0.005);
  const auto along = look(block("[probe]\nkind = \"surface\"\nfrom = [0, 0.3]\nto = [2, 0.3]\n"));
  EXPECT_NEAR(1.0, along[1], 0.005);
  const auto dry = look(block("[probe]\nkind = \"surface\"\nfrom = [1.5, 0]\nto = [1.5, 1]\n"));
  EXPECT_EQ(0, dry[1]);
}

TEST(Probes, InterpolateInAPlane) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  Simulation sim = simulation_of(
      block("[probe]\nkind = \"plane\"\nfrom = [0.2, 0.1]\nto = [0.8, 0.5]\napart = 0.2\n"));
  const std::string lines = Probes(sim.scene()).look(sim).at(0);
  std::istringstream in(lines);
  std::vector<std::array<double, 3>> told;  // x, y, velocity along x
  for (std::string line; std::getline(in, line);) {
    std::array<double, 8> n{};
    std::istringstream words(line);
    for (double& a : n) {
      std::string word;
      std::getline(words, word, ',');
      a = std::stod(word);
    }
    told.push_back({n[1], n[2], n[4]});
  }
  ASSERT_EQ(12u, told.size()) << "4 places along x, 3 along y";
  for (std::size_t k = 0; k < told.size(); ++k) {
    EXPECT_NEAR(0.2 + 0.2 * double(k % 4), told[k][0], 1e-9);
    EXPECT_NEAR(0.1 + 0.2 * double(k / 4), told[k][1], 1e-9);
    EXPECT_NEAR(told[k][1], told[k][2], 1e-3);
  }
}

TEST(Probes, MoveWithABody) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  Simulation sim = simulation_of(
      block("[[body]]\nname = \"gate\"\nmin = [1.4, 0.3]\nmax = [1.6, 0.5]\nmotion = "
            "\"moved\"\nangle = \"5000*t\"\npivot = [1.5, 0.4]\n[probe]\nat = [1.5, 1.4]\n"
            "body = \"gate\"\n"));
  Probes probes(sim.scene());
  const auto told = [&] {  // t, x, y, fraction
    std::array<double, 4> n{};
    const std::string line = probes.look(sim).at(0);
    EXPECT_EQ(4, std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &n[0], &n[1], &n[2], &n[3])) << line;
    return n;
  };
  EXPECT_EQ(0, told()[3]) << "the probe must start above the water";
  for (int k = 0; k < 180; ++k) sim.step();
  const auto [t, x, y, fraction] = told();
  const double turned = 5000 * t * std::numbers::pi / 180;  // a quarter turn
  EXPECT_NEAR(1.5 - std::sin(turned), x, 1e-5);
  EXPECT_NEAR(0.4 + std::cos(turned), y, 1e-5);
  EXPECT_NEAR(1, fraction, 0.05) << "the probe must be in the water";
}

TEST(Probes, SumAcrossAPeriodicEnd) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const std::string periodic = "periodic = \"y\"\n";
  std::string full = block("[probe]\nat = [0.5, 0.0]\n", periodic);
  full.replace(full.find("max = [1, 0.6]"), 14, "max = [1, 1.0]");
  EXPECT_NEAR(1, look(full)[3], 0.02);
}

TEST(Probes, HaveTheSameBitsOnBothBackends) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const std::string text = block(
      "[probe]\nkind = \"line\"\nfrom = [0, 0.3]\nto = [1.2, 0.3]\n"
      "count = 20\n");
  const auto told = [&](const char* backend, int threads) {
    Simulation sim = simulation_of(text, backend, {threads, ""});
    for (int k = 0; k < 10; ++k) sim.step();
    return Probes(sim.scene()).look(sim);
  };
  EXPECT_EQ(told("reference", 1), told("cpu", 2));
  EXPECT_EQ(20, std::ranges::count(told("cpu", 1)[0], '\n'));
}

}  // namespace
}  // namespace freshet::test

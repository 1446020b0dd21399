// SPDX-License-Identifier: MIT
// Wall probes against the forces on whole walls and against hydrostatics.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "sim/forced.h"
#include "sim/probe_places.h"
#include "sim/probes.h"

namespace freshet::test {
namespace {

struct Water {
  const char *solver, *method;
};
void PrintTo(const Water& w, std::ostream* out) { *out << w.solver << ", " << w.method; }

std::string stretch(double from, double to) {
  std::ostringstream text;
  text << "[[probe]]\nkind = \"wall\"\nfrom = [1.0, " << from << "]\nto = [1.0, " << to << "]\n";
  return text.str();
}

/// Water 0.5 m deep in a tank 1 m wide.
std::string tank(const Water& w, const std::string& probes) {
  return "[domain]\nmax = [1.0, 0.8]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\nmax = "
         "[1, 0.5]\npressure = \"hydrostatic\"\n" +
         probes + "[walls]\nmethod = \"" + w.method +
         "\"\ny_max = \"open\"\nslip = \"free_slip\"\n[solver]\nname = \"" + w.solver + "\"\n" +
         (std::string(w.solver) == "delta_sph" ? "sound_speed = 30\n" : "") +
         "[time]\nend = 2\nstep = \"adaptive\"\nstep_max = 0.002\n";
}

/// The numbers of the first line of each probe.
std::vector<std::vector<double>> look(Simulation& sim) {
  std::vector<std::vector<double>> told;
  for (const std::string& lines : Probes(sim.scene()).look(sim)) {
    std::istringstream in(lines);
    told.emplace_back();
    for (std::string word; std::getline(in, word, ',');) told.back().push_back(std::stod(word));
  }
  return told;
}

class WallProbes : public ::testing::TestWithParam<Water> {
  void SetUp() override {
    if (!compiled(GetParam().solver)) GTEST_SKIP() << "not compiled in this build";
  }
};

TEST_P(WallProbes, MeasureHydrostaticPressure) {
  Simulation sim = simulation_of(tank(GetParam(), stretch(0.05, 0.15) + stretch(0.2, 0.35)));
  double low = 0, high = 0;
  int counted = 0;
  while (sim.time() < 2) {
    sim.step();
    if (sim.time() < 1) continue;
    const auto told = look(sim);
    low += told[0][1];
    high += told[1][1];
    ++counted;
  }
  EXPECT_NEAR(1, low / counted / (9810 * 0.4), 0.05);
  EXPECT_NEAR(1, high / counted / (9810 * 0.225), 0.05);
}

TEST_P(WallProbes, AddUpToTheForceOnTheWall) {
  Simulation sim = simulation_of(tank(
      GetParam(), stretch(0, 0.07) + stretch(0.07, 0.31) + stretch(0.31, 0.8) + stretch(0, 0.8)));
  for (int k = 0; k < 50; ++k) sim.step();
  const auto told = look(sim);
  const double all = 0.8 * told[3][1];
  EXPECT_NEAR(all, 0.07 * told[0][1] + 0.24 * told[1][1] + 0.49 * told[2][1], 1e-6 * all);
  EXPECT_NEAR(1, all / sim.wall_forces()[1][0], 0.08) << "the wall includes the corner";
}

INSTANTIATE_TEST_SUITE_P(Solvers, WallProbes,
                         ::testing::Values(Water{"delta_sph", "adami2012"},
                                           Water{"delta_sph", "akinci2012"},
                                           Water{"dfsph", "akinci2012"},
                                           Water{"iisph", "akinci2012"}));

TEST(WallProbe, HasTheSameBitsOnAnyThreadsAndBackend) {
  const auto told = [](const char* backend, int threads) {
    Simulation sim =
        simulation_of(tank({"dfsph", "akinci2012"}, stretch(0.07, 0.31)), backend, {threads, ""});
    for (int k = 0; k < 10; ++k) sim.step();
    return Probes(sim.scene()).look(sim);
  };
  const auto one = told("cpu", 1);
  EXPECT_EQ(one, told("cpu", 7));
  EXPECT_EQ(one, told("cpu", 2));
  EXPECT_EQ(one, told("reference", 1));
}

TEST(WallProbe, DoesNotChangeTheSimulation) {
  const auto sum = [](bool asked) {
    Simulation sim = simulation_of(tank({"delta_sph", "adami2012"}, stretch(0.07, 0.31)));
    for (int k = 0; k < 20; ++k) {
      sim.step();
      if (asked) Probes(sim.scene()).look(sim);
    }
    return sim.kept_sha256();
  };
  EXPECT_EQ(sum(false), sum(true));
}

TEST(WallProbe, PatchMovesWithABody) {
  const Simulation sim = simulation_of(
      "[domain]\nmax = [2.0, 2.0]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\nmax = [2, "
      "0.3]\n[[body]]\nname = \"plate\"\nmin = [0.8, 0.9]\nmax = [1.2, 1.1]\nmotion = "
      "\"fixed\"\n[[probe]]\nkind = \"wall\"\nfrom = [1.2, 0.9]\nto = [1.2, 1.1]\nbody = "
      "\"plate\"\n[solver]\nname = \"dfsph\"\n[time]\nend = 1\nstep = 1e-3\n");
  BodyState quarter;
  quarter.position = {1.5, 0.5, 0};
  quarter.orientation = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // a quarter turn about z
  const auto patches = ProbePlaces(sim.scene()).patches({quarter});
  ASSERT_EQ(1u, patches.size());
  EXPECT_NEAR(1.5, patches[0].center[0], 1e-12);
  EXPECT_NEAR(0.7, patches[0].center[1], 1e-12);
  EXPECT_NEAR(1, patches[0].axes[0][1], 1e-12) << "the x axis must have become the y axis";
  EXPECT_NEAR(-1, patches[0].axes[1][0], 1e-12);
  EXPECT_NEAR(0.1, patches[0].half[1], 1e-12);
  EXPECT_EQ(0, patches[0].half[0]);
}

// Water 0.5 m deep on a slope of 45 degrees, which rises from (0.6, 0).
TEST(WallProbe, MeasuresHydrostaticPressureOnASlope) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1.4, 0.8]\n[particles]\nspacing = 0.025\n[fluid]\nmin = [0, 0]\nmax = "
      "[1.4, 0.5]\npressure = \"hydrostatic\"\n[[wall]]\nshape = \"plane\"\npoint = [0.6, "
      "0]\nnormal = [-1, 1]\nslip = \"free_slip\"\n[[probe]]\nkind = \"wall\"\nfrom = [0.7, "
      "0.1]\nto = [0.9, 0.3]\n[walls]\nslip = \"free_slip\"\n[solver]\nname = "
      "\"delta_sph\"\nsound_speed = 30\n[time]\nend = 2\nstep = \"adaptive\"\nstep_max = "
      "0.002\n");
  double x = 0, y = 0;
  int counted = 0;
  while (sim.time() < 2) {
    sim.step();
    if (sim.time() < 1) continue;
    const auto told = look(sim);
    x += told[0][1];
    y += told[0][2];
    ++counted;
  }
  const double p = 9810 * 0.3 * std::sqrt(0.5);
  EXPECT_NEAR(1, x / counted / p, 0.05);
  EXPECT_NEAR(-1, y / counted / p, 0.05);
}

TEST(WallProbe, PatchIsAnInclinedRectangle) {
  const Simulation sim = simulation_of(
      "[domain]\nmax = [1, 1, 1]\n[particles]\nspacing = 0.1\n[fluid]\nmin = [0, 0, 0]\nmax = [1, "
      "0.3, 1]\n[[probe]]\nkind = \"wall\"\nfrom = [0, 0, 0.4]\nto = [0.3, 0.4, 1]\nalong = [3, "
      "4, 0]\n[solver]\nname = \"dfsph\"\n[time]\nend = 1\nstep = 1e-3\n");
  const WallPatch patch = ProbePlaces(sim.scene()).patches({}).at(0);
  EXPECT_NEAR(0.25, patch.half[0], 1e-12);
  EXPECT_NEAR(0.3, patch.half[1], 1e-12);
  EXPECT_EQ(0, patch.half[2]);
  EXPECT_NEAR(0.6, patch.axes[0][0], 1e-12);
  EXPECT_NEAR(0.8, patch.axes[0][1], 1e-12);
  EXPECT_NEAR(1, patch.axes[1][2], 1e-12);
  EXPECT_NEAR(0.2, patch.center[1], 1e-12);
  EXPECT_NEAR(0.7, patch.center[2], 1e-12);
}

TEST(WallProbe, WarnsIfThereIsNoWall) {
  const auto warnings = [](const char* place) {
    const std::string probe = std::string("[[probe]]\nkind = \"wall\"\nfrom = [") + place +
                              ", 0.1]\nto = [" + place + ", 0.2]\n";
    return scene_warnings(parse_scene(tank({"dfsph", "akinci2012"}, probe), "test.toml"));
  };
  EXPECT_TRUE(warnings("1.0").empty());
  const auto partly =
      scene_warnings(parse_scene(tank({"dfsph", "akinci2012"}, stretch(0.4, 1.6)), "test.toml"));
  ASSERT_EQ(1u, partly.size());
  EXPECT_NE(std::string::npos, partly[0].message.find("of this probe has no boundary particle"));
  ASSERT_EQ(1u, warnings("0.5").size());
  EXPECT_NE(std::string::npos, warnings("0.5")[0].message.find("no boundary particle"));
}

// dfsph, 0.3 m of water: the particles beside the floor have 1.55 times its pressure.
TEST(PointProbe, WarnsBesideWallsThatMirrorThePressure) {
  const auto warnings = [](const Water& w, const char* x) {
    const std::string probe = std::string("[[probe]]\nat = [") + x + ", 0.2]\n";
    return scene_warnings(parse_scene(tank(w, probe), "test.toml"));
  };
  ASSERT_EQ(1u, warnings({"dfsph", "akinci2012"}, "1.0").size());
  EXPECT_NE(std::string::npos,
            warnings({"dfsph", "akinci2012"}, "1.0")[0].message.find("kind = \"wall\""));
  EXPECT_TRUE(warnings({"dfsph", "akinci2012"}, "0.85").empty());
  EXPECT_TRUE(warnings({"delta_sph", "adami2012"}, "1.0").empty());
}

TEST(WallProbe, RejectsAPatchOfAnotherDimension) {
  Simulation sim = simulation_of(tank({"dfsph", "akinci2012"}, ""));
  EXPECT_THROW(sim.tractions({{{1, 0.2}, {0, 0.1}, {{1, 0, 0}, {0, 1, 0}}}}), Error);
  EXPECT_THROW(sim.tractions({{{1, 0.2, 0}, {0, 0.1, 0}, {{1, 0}, {0, 1}}}}), Error);
}

TEST(WallProbe, MeasuresHydrostaticPressureIn3D) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [0.6, 0.6, 0.6]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0, "
      "0]\nmax = [0.6, 0.4, 0.6]\npressure = \"hydrostatic\"\n[[probe]]\nkind = \"wall\"\nfrom = "
      "[0.6, 0.1, 0.2]\nto = [0.6, 0.2, 0.5]\n[walls]\nmethod = \"adami2012\"\ny_max = "
      "\"open\"\nslip = \"free_slip\"\n[solver]\nname = \"delta_sph\"\nsound_speed = "
      "30\n[time]\nend = 0.2\nstep = \"adaptive\"\nstep_max = 0.002\n");
  while (!sim.finished()) sim.step();
  const auto told = look(sim);
  ASSERT_EQ(4u, told[0].size());
  EXPECT_NEAR(1, told[0][1] / (9810 * 0.25), 0.03);
  EXPECT_NEAR(0, told[0][3] / (9810 * 0.25), 0.01);
}

}  // namespace
}  // namespace freshet::test

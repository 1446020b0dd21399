// SPDX-License-Identifier: MIT
// Derived numbers, defaults and warnings of scenes with a pressure solver.
#include <gtest/gtest.h>

#include <cmath>

#include "freshet/derived.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

constexpr const char* names[] = {"pcisph", "iisph", "dfsph", "pbf"};

Scene scene_of(const std::string& solver, const std::string& more, const std::string& before = "") {
  return scene_with("[1, 2]", 0.1,
                    before + "solver.name = \"" + solver +
                        "\"\n[fluid]\nmin = [0, 0]\nmax = [0.5, 1]\nrest_density = 800\n" + more);
}

TEST(PressureSolvers, HaveTimeStepLimitsWithoutSound) {
  for (const char* name : names) {
    const Derived d = derive(scene_of(name, "velocity = [3, 4]\nviscosity = 0.5\n"));
    EXPECT_EQ(INFINITY, d.acoustic_step);
    EXPECT_NEAR(0.25 * std::sqrt(0.1 / 9.81), d.force_step, 1e-12);
    EXPECT_NEAR(0.125 * 0.01 * 800 / 0.5, d.viscous_step, 1e-9);
    EXPECT_NEAR(0.4 * 0.1 / 5, d.flow_step, 1e-7);
    EXPECT_EQ(d.flow_step, d.step_bound());
    EXPECT_STREQ("flow", d.step_bound_name());
    EXPECT_NEAR(800 * 0.1 * 0.1, d.mass, 1e-9);
  }
  const Derived still = derive(scene_of("iisph", "viscosity = 100\n"));
  EXPECT_EQ(INFINITY, still.flow_step);
  EXPECT_STREQ("viscosity", still.step_bound_name());
  EXPECT_STREQ("gravity", derive(scene_of("iisph", "")).step_bound_name());
  const std::string moving = "[fluid]\nmin = [0, 0]\nmax = [0.5, 1]\nvelocity = [3, 4]\n";
  EXPECT_EQ(INFINITY, derive(scene_with("[1, 2]", 0.1, moving)).flow_step);
}

TEST(PressureSolvers, HaveANominalSoundSpeedOfTenTimesFallOrStart) {
  const double fall2 = 2 * 9.81 * 1;  // from the top of the fluid
  const auto speed = [](const std::string& fluid, const std::string& before = "") {
    return derive(scene_of("pbf", fluid, before)).sound_speed;
  };
  EXPECT_NEAR(10 * std::sqrt(25 + fall2), speed("velocity = [3, 4]\n"), 1e-6);
  EXPECT_NEAR(10 * std::sqrt(100 + fall2), speed("velocity = [6, -8]\n"), 1e-6);
  EXPECT_NEAR(50, speed("velocity = [3, 4]\n", "domain.gravity = [0, 0]\n"), 1e-6);
  EXPECT_EQ(0, speed("", "domain.gravity = [0, 0]\n"));
}

TEST(PressureSolvers, HaveDefaultDensityTolerances) {
  for (const char* name : names)
    EXPECT_EQ(std::string(name) == "dfsph" ? 3e-4 : 1e-3,
              derive(scene_of(name, "")).density_tolerance);
  const std::string at_once = "solver.density_correction = \"at_once\"\n";
  EXPECT_EQ(1e-4, derive(scene_of("dfsph", "", at_once)).density_tolerance);
  EXPECT_EQ(1e-3, derive(scene_of("iisph", "", at_once)).density_tolerance);
  const std::string given = "solver.density_tolerance = 0.02\n";
  EXPECT_EQ(0.02, derive(scene_of("dfsph", "", given)).density_tolerance);
  EXPECT_EQ(0, derive(scene_of("delta_sph", "")).density_tolerance);
}

TEST(PressureSolvers, HaveWallsOfAkinci2012ByDefault) {
  for (const char* name : names)
    EXPECT_EQ(WallMethod::akinci2012, scene_of(name, "").side_method(0));
}

TEST(PressureSolvers, StartHydrostaticFluidsAtRestDensity) {
  for (const char* name : names) {
    const Sample flat = sample(scene_of(name, ""));
    const Sample s = sample(scene_of(name, "pressure = \"hydrostatic\"\n"));
    EXPECT_TRUE(flat.pressure.empty());
    EXPECT_EQ(flat.x, s.x);  // hydrostatic pressure does not move the particles
    ASSERT_EQ(50u, s.pressure.size());
    for (std::size_t i = 0; i < 50; ++i) {
      EXPECT_EQ(Real(800), s.density[i]);
      EXPECT_NEAR(800 * 9.81 * (1 - double(s.x[2 * i + 1])), s.pressure[i], 0.01) << i;
    }
  }
  EXPECT_TRUE(sample(scene_of("wcsph", "pressure = \"hydrostatic\"\n")).pressure.empty());
}

TEST(PressureSolvers, ApplyHydrostaticPressurePerFluid) {
  const Sample s = sample(
      scene_with("[1, 1]", 0.1,
                 "solver.name = \"dfsph\"\n[[fluid]]\nmin = [0, 0]\nmax = [0.2, 0.2]\n"
                 "[[fluid]]\nmin = [0.5, 0]\nmax = [0.7, 0.2]\npressure = \"hydrostatic\"\n"));
  ASSERT_EQ(8u, s.pressure.size());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(Real(0), s.pressure[i]);
  EXPECT_NEAR(1000 * 9.81 * 0.15, s.pressure[4], 0.01);
  EXPECT_NEAR(1000 * 9.81 * 0.05, s.pressure[7], 0.01);
}

TEST(PressureSolvers, WarnOfAStepOverTheFlowLimit) {
  const auto warnings = [](const std::string& more) {
    return scene_warnings(scene_of("pcisph", more));
  };
  EXPECT_TRUE(warnings("velocity = [100, 0]\n").empty());  // the limit is 4e-4 s, the step 1e-4 s
  const auto fast = warnings("velocity = [500, 0]\n");
  ASSERT_EQ(1u, fast.size());
  EXPECT_NE(std::string::npos, fast[0].message.find("over its bound, 8e-05 s (flow)"))
      << fast[0].message;
  for (const char* support : {"0.2", "0.25"})
    EXPECT_TRUE(
        scene_warnings(
            scene_of("dfsph", "", std::string("particles.support_radius = ") + support + "\n"))
            .empty())
        << support;
}

}  // namespace
}  // namespace freshet::test

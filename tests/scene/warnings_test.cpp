// SPDX-License-Identifier: MIT
// Warnings of scenes that can run, and errors of scenes that are bound to fail.
#include <gtest/gtest.h>

#include <string>

#include "freshet/scene.h"

namespace freshet::test {
namespace {

/// A dam break of 1 m × 2 m of water in a box of 4 m × 2 m.
std::string dam(const std::string& solver, const std::string& time, const std::string& more = "") {
  return "[domain]\nmax = [4.0, 2.0]\n[particles]\nspacing = 0.1\n[fluid]\nmin = [0, 0]\n"
         "max = [1, 2]\n[solver]\nname = \"" +
         solver + "\n[time]\n" + time + more;
}

/// All warnings, or the error.
std::string warnings_of(const std::string& text) {
  std::string all;
  try {
    for (const Diagnostic& d : scene_warnings(parse_scene(text, "s.toml"))) all += d.text() + "\n";
  } catch (const Error& e) {
    all = e.what();
  }
  return all;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string adaptive = "end = 1.0\nstep = \"adaptive\"\nstep_max = 0.01\n";

TEST(SceneWarnings, SoundSlowerThanFiveTimesAFall) {
  const std::string slow = warnings_of(dam("wcsph\"\nsound_speed = 25.0", adaptive));
  EXPECT_TRUE(contains(slow,
                       "s.toml:10:15: warning: the speed of sound is 25 m/s, and a fall through "
                       "the domain reaches 6.264"))
      << slow;
  EXPECT_TRUE(contains(slow, "compresses the fluid by about 6.28 %")) << slow;
  EXPECT_EQ("", warnings_of(dam("wcsph\"\nsound_speed = 35.0", adaptive)));
  EXPECT_EQ("", warnings_of(dam("dfsph\"", adaptive)));
}

TEST(SceneWarnings, SoundThatDoesNotCarryTheWeightIsAnError) {
  const std::string soft = "wcsph\"\nsound_speed = 2.5";
  const std::string longer = "end = 3.0\nstep = \"adaptive\"\nstep_max = 0.01\n";
  EXPECT_TRUE(contains(warnings_of(dam(soft, longer)),
                       "s.toml:10:15: error: solver.sound_speed is 2.5: at rest, the weight"))
      << warnings_of(dam(soft, longer));
  EXPECT_TRUE(contains(warnings_of(dam(soft, adaptive)), "warning: "));  // ends before it settles
  EXPECT_TRUE(contains(warnings_of(dam(soft, longer, "[checks]\nwhen_wrong = \"warn\"\n")),
                       "warning: the speed"));
}

TEST(SceneWarnings, FixedStepOverItsBound) {
  EXPECT_TRUE(
      contains(warnings_of(dam("wcsph\"", "end = 1.0\nstep = 0.005\n")), "warning: the time step"));
}

TEST(SceneWarnings, OutputMoreOftenThanTheRealStep) {
  const std::string every = "[output]\nobservables_every = ";
  // step_max is 0.01 s, and the sound makes the step shorter
  EXPECT_EQ("", warnings_of(dam("wcsph\"", adaptive, every + "0.002\n")));
  EXPECT_TRUE(contains(warnings_of(dam("wcsph\"", adaptive, every + "0.0002\n")),
                       "warning: output.observables_every is 0.0002 s, shorter than the time step, "
                       "about 0.0006386 s"));
  EXPECT_TRUE(
      contains(warnings_of(dam("wcsph\"", "end = 1.0\nstep = 0.0005\n", every + "0.0002\n")),
               "error: output.observables_every"));
}

TEST(SceneWarnings, ProbeOutsideTheDomain) {
  const auto at = [](const std::string& x) {
    return warnings_of(dam("dfsph\"", adaptive, "[[probe]]\nat = [" + x + ", 0.5]\n"));
  };
  EXPECT_TRUE(contains(at("4.2"), "warning: this point is outside the domain")) << at("4.2");
  EXPECT_EQ("", at("3.5"));
}

TEST(SceneWarnings, DensityRatioOfPressureSolvers) {
  const auto over = [](const std::string& density, const std::string& solver) {
    return warnings_of(
        "[domain]\nmax = [1, 1]\n[particles]\nspacing = 0.1\n[[fluid]]\nmin = [0, 0]\n"
        "max = [1, 0.5]\n[[fluid]]\nmin = [0, 0.5]\nmax = [1, 1]\nrest_density = " +
        density + "\n[solver]\nname = \"" + solver + "\"\n[time]\n" + adaptive);
  };
  EXPECT_EQ("", over("40", "dfsph"));
  EXPECT_TRUE(contains(over("20", "dfsph"),
                       "s.toml:11:16: warning: a liquid is 50 times as dense as another, and the "
                       "pressure of dfsph holds ratios up to about 30"))
      << over("20", "dfsph");
  EXPECT_TRUE(contains(over("1.2", "dfsph"), "error: a liquid is 833.3 times as dense"));
  EXPECT_EQ("", over("1.2", "wcsph"));
}

TEST(SceneWarnings, DeepStillWaterOfDfsph) {
  const auto still = [](const std::string& depth, const std::string& more) {
    return warnings_of(
        "[domain]\nmax = [1, 6]\n[particles]\nspacing = 0.1\n[fluid]\nmin = [0, 0]\n"
        "max = [1, " +
        depth + "]\npressure = \"hydrostatic\"\n[solver]\nname = \"dfsph\"\n" + more + "[time]\n" +
        adaptive);
  };
  const std::string at_once = "density_correction = \"at_once\"\n";
  EXPECT_EQ("", still("5.0", ""));
  EXPECT_EQ("", still("3.0", at_once));
  EXPECT_TRUE(contains(still("5.0", at_once),
                       "still water 50 spacings deep keeps moving at about 0.17 "
                       "m/s with dfsph; set solver.density_correction = \"gradual\""))
      << still("5.0", at_once);
  EXPECT_EQ("", still("5.0", at_once + "warm_start = false\n"));
}

TEST(SceneWarnings, ProbeInsideASolid) {
  const auto of = [](const std::string& more) {
    return warnings_of(dam("dfsph\"", adaptive, more));
  };
  const std::string wall = "[[wall]]\nname = \"step\"\nmin = [2, 0]\nmax = [3, 1]\n",
                    body = "[[body]]\nname = \"crate\"\nmin = [2, 0.5]\nmax = [3, 1.5]\nmotion = ";
  EXPECT_TRUE(contains(of(wall + "[[probe]]\nat = [2.5, 0.5]\n"),
                       "warning: this point is inside step, where it finds no fluid"));
  EXPECT_TRUE(
      contains(of(wall + "[[probe]]\nkind = \"line\"\nfrom = [2.1, 0.1]\nto = [2.9, 0.9]\n"),
               "warning: all of this probe is inside step"));
  EXPECT_EQ("", of(wall + "[[probe]]\nkind = \"line\"\nfrom = [2.1, 0.1]\nto = [2.9, 1.6]\n"));
  EXPECT_TRUE(contains(of(body + "\"fixed\"\n[[probe]]\nat = [2.5, 1.0]\n"), "is inside crate"));
  EXPECT_EQ("", of(body + "\"free\"\ndensity = 500\n[[probe]]\nat = [2.5, 1.0]\n"))
      << "a free body leaves";
}

TEST(SceneWarnings, BodiesOfOneLayerInDeltaSph) {
  const auto with = [](const std::string& solver, const std::string& method, const char* side) {
    return warnings_of(
        "[domain]\nmax = [2.0, 2.0]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0.5, 0.5]\n"
        "max = [1.5, 1]\n[walls]\nmethod = \"" +
        method + "\"\n[solver]\nname = \"" + solver +
        "\"\n[time]\nend = 0.01\nstep = \"adaptive\"\nstep_max = 0.001\n[[body]]\n" + side);
  };
  const char *ball = "shape = \"sphere\"\ncenter = [1, 0.75]\nradius = 0.2\n",
             *tank = "min = [0.5, 0.5]\nmax = [1.5, 1.5]\nside = \"inside\"\n";
  EXPECT_TRUE(contains(with("delta_sph", "akinci2012", ball),
                       "s.toml:9:10: warning: with walls.method = \"akinci2012\", a body has one "
                       "layer of \"akinci2012\" particles, which delta_sph lifts too strongly"))
      << with("delta_sph", "akinci2012", ball);
  EXPECT_TRUE(contains(with("delta_sph", "open", ball), "lifts too strongly"));
  EXPECT_FALSE(contains(with("delta_sph", "adami2012", ball), "lifts too strongly"));
  EXPECT_FALSE(contains(with("dfsph", "akinci2012", ball), "lifts too strongly"));
  EXPECT_FALSE(contains(with("delta_sph", "open", tank), "lifts too strongly"));
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Polygons of files in 2D: closed outlines, and open lines that a base closes.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/derived.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

/// A beach from a file: flat until x = 1, then 0.3 m up to x = 2.
class Bathymetry : public ::testing::Test {
 protected:
  Scene scene(const std::string& csv, const std::string& keys) const {
    write_text(folder / "bottom.csv", csv);
    write_text(folder / "scene.toml",
               "domain.max = [2, 0.6]\nparticles.spacing = 0.02\nsolver.name = \"dfsph\"\n"
               "time = { end = 0.01, step = 1e-4 }\n"
               "[[fluid]]\nmin = [0, 0]\nmax = [2, 0.4]\n"
               "[[wall]]\nshape = \"polygon\"\nfile = \"bottom.csv\"\n" +
                   keys);
    return load_scene(folder / "scene.toml");
  }
  std::string error_of(const std::string& csv, const std::string& keys) const {
    try {
      scene(csv, keys);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  }
  const TemporaryFolder folder;
};

TEST_F(Bathymetry, OfAnOpenLineIsClosedByItsBase) {
  const Scene open = scene("x,y\n0,0.1\n1,0.1\n2,0.4\n", "base = -0.1\n");
  const Scene closed = scene("x,y\n0,0.1\n1,0.1\n2,0.4\n2,-0.1\n0,-0.1\n", "");
  const Sample a = sample(open), b = sample(closed);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.akinci2012.x, b.akinci2012.x);
  const Derived d = derive(open);
  ASSERT_TRUE(d.fluids[0].asked);
  EXPECT_NEAR(d.fluids[0].filled, 0.3 + 0.15, 0.005);
}

TEST_F(Bathymetry, MayRunFromRightToLeftAndLieAbove) {
  const Scene lid = scene("x,y\n2,0.5\n1,0.45\n0,0.5\n", "base = 0.6\n");
  EXPECT_NEAR(derive(lid).fluids[0].filled, 0.8, 1e-9);
}

TEST_F(Bathymetry, NamesFileAndLineOfAnError) {
  const std::string file = (folder / "bottom.csv").string();
  EXPECT_TRUE(contains(error_of("x,y\n0,0.1\n1,a\n2,0.4\n", "base = -0.1\n"),
                       file + ":3: error: value 2 is not a number"));
  EXPECT_TRUE(contains(error_of("# survey\nx,y\n0,0.1\n1,0.1\n1,0.1\n2,0.4\n", "base = -0.1\n"),
                       file + ":5: error: the polygon has the corner [1, 0.1] twice in succession; "
                              "remove one"));
  EXPECT_TRUE(contains(error_of("x,y\n0,0.1\n2,0.1\n1,0.3\n1,-0.05\n2,0.4\n", "base = -0.1\n"),
                       file + ":"));
  EXPECT_TRUE(contains(error_of("x,y\n0,0.1\n2,0.1\n1,0.3\n1,-0.05\n2,0.4\n", "base = -0.1\n"),
                       "crosses or touches itself"));
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
/// The text that a scene keeps as its source can be read again from the folder of its run.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/scene.h"
#include "scene/model/inputs.h"

namespace freshet::test {
namespace {

const std::string start =
    "domain.max = [1, 1]\nparticles.spacing = 0.05\n"
    "time = { end = 0.01, step = 1e-4 }\n";

TEST(SceneSource, IsTheTextItself) {
  const std::string text = start + "fluid = { min = [0, 0], max = [0.5, 0.5] }  # water\n";
  EXPECT_EQ(text, parse_scene(text, "scenes/test.toml").source);
}

TEST(SceneSource, OfARunNamesCopiesOfItsFiles) {
  const TemporaryFolder folder;
  write_text(folder / "mine/water.csv", "x,y\n0.2,0.2\n0.3,0.2\n");
  const std::string fluids[] = {"fluid = { shape = \"points\", file = \"water.csv\" }\n",
                                "[[fluid]]\nshape = \"points\"\nfile = \"water.csv\"\n"
                                "[[fluid]]\nmin = [0.5, 0.5]\nmax = [1, 1]\n"};
  for (const std::string& fluid : fluids) {
    write_text(folder / "mine/scene.toml", start + fluid);
    const Scene scene = load_scene(folder / "mine/scene.toml");
    const Inputs inputs = inputs_of(scene);
    ASSERT_EQ(1u, inputs.files.size());
    EXPECT_EQ(read_text(folder / "mine/water.csv"), inputs.files[0].second);
    EXPECT_EQ("inputs/fluid_0_water.csv", inputs.files[0].first);
    write_text(folder / "run/inputs/fluid_0_water.csv", read_text(folder / "mine/water.csv"));
    write_text(folder / "run/scene.toml", inputs.source);
    const Scene again = load_scene(folder / "run/scene.toml");
    EXPECT_EQ((folder / "run/inputs/fluid_0_water.csv").string(), again.fluid.at(0).file);
    EXPECT_EQ(scene.fluid.size(), again.fluid.size());
  }
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Scenes with meshes that have holes.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "mesh/triangle_mesh.h"
#include "scene/model/setup.h"

namespace freshet::test {
namespace {

const std::filesystem::path small_holes =
    source_dir / "tests/scenes/good/mesh_with_small_holes.toml";

TEST(MeshHoles, ThatAreNarrowAreFilledWithAWarning) {
  if (!reads_meshes()) GTEST_SKIP() << "built without Assimp";
  const Scene s = load_scene(small_holes);
  std::string text;
  for (const Diagnostic& d : scene_warnings(s)) text += d.text() + "\n";
  EXPECT_NE(text.find("chipped_box.obj had 2 holes narrower than the spacing, filled with flat "
                      "triangles: a hole of 4 edges near [0.615, 0.315, 0.7], 0.03 m wide; a hole "
                      "of 3 edges near [0.6, 0.1, 0.7003], 0.001 m wide"),
            std::string::npos)
      << text;
  EXPECT_EQ(8u * 8 * 8, sample(s).density.size()) << "the fluid fills the box";
}

// A sheet keeps its holes, so that fluid passes them.
TEST(MeshHoles, OfASheetStay) {
  if (!reads_meshes()) GTEST_SKIP() << "built without Assimp";
  const Scene s = parse_scene(
      "domain.max = [1, 1, 1]\nparticles.spacing = 0.05\nsolver.name = \"wcsph\"\n"
      "time = { end = 1, step = 1e-4 }\nfluid = { min = [0, 0, 0], max = [0.1, 0.1, 0.1] }\n"
      "wall = { shape = \"mesh\", file = \"meshes/chipped_box.obj\", "
      "translation = [0.6, 0.3, 0.5] }\n",
      (source_dir / "tests/scenes/sheet.toml").string());
  std::string text;
  for (const Diagnostic& d : scene_warnings(s)) text += d.text() + "\n";
  EXPECT_NE(text.find("chipped_box.obj is not closed, a hole of 4 edges near"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("filled"), std::string::npos) << text;
}

}  // namespace
}  // namespace freshet::test

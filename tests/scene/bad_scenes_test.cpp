// SPDX-License-Identifier: MIT
/// Every scene of tests/scenes/bad is refused with the words beside it, which are what a user
/// reads.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/files.h"
#include "cli/process.h"
#include "freshet/real.h"
#include "mesh/triangle_mesh.h"
#include "scene/body_shape.h"
#include "scene/expressions.h"

namespace freshet::test {
namespace {

constexpr double time_limit = 10;  // [s]: a hang is a failure

std::vector<std::string> scenes_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_dir / "tests/scenes" / folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return info.param; }

ProcessResult check(const std::string& scene) {
  return freshet({"check", scene}, {.directory = source_dir, .seconds = time_limit});
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, IsRefusedInTheseWords) {
  if (GetParam().ends_with("_float") && sizeof(Real) != sizeof(float))
    GTEST_SKIP() << "the words name 32-bit numbers";
  if (GetParam().starts_with("mesh_") && !reads_meshes()) GTEST_SKIP() << "built without Assimp";
  const bool free = GetParam().starts_with("body_") || GetParam().starts_with("joint_");
  if (free && !moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  if (GetParam().starts_with("without_bullet_") && moves_free_bodies())
    GTEST_SKIP() << "built with Bullet";
  if (GetParam().starts_with("body_function_") && !reads_expressions())
    GTEST_SKIP() << "built without muParser";
  if (GetParam().starts_with("function_") && !reads_expressions())
    GTEST_SKIP() << "built without muParser";
  const std::string scene = "tests/scenes/bad/" + GetParam();
  const std::string expected = read_text(source_dir / (scene + ".expected"));
  const auto r = check(scene + ".toml");
  EXPECT_FALSE(r.timed_out);
  EXPECT_EQ(r.ended_by, 0) << "ended by a signal";
  EXPECT_EQ(std::to_string(r.code) + "\n" + r.err, expected);
  EXPECT_EQ(r.out, "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadScene, testing::ValuesIn(scenes_in("bad")), name_of);

class GoodScene : public testing::TestWithParam<std::string> {};

TEST_P(GoodScene, Passes) {
  if (GetParam().starts_with("mesh_") && !reads_meshes()) GTEST_SKIP() << "built without Assimp";
  if (GetParam() == "probes_of_every_kind" && !reads_expressions())
    GTEST_SKIP() << "built without muParser";
  const std::string scene = "tests/scenes/good/" + GetParam() + ".toml";
  const auto r = check(scene);
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err.find("error"), std::string::npos) << r.err;
  EXPECT_TRUE(r.out.starts_with(scene + ": a good scene")) << r.out;
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoodScene, testing::ValuesIn(scenes_in("good")), name_of);

TEST(GoodScenes, KeepTheirBytes) {  // git or an editor may have changed marks and line ends
  EXPECT_TRUE(read_text(source_dir / "tests/scenes/good/bom.toml").starts_with("\xEF\xBB\xBF"));
  EXPECT_NE(read_text(source_dir / "tests/scenes/good/windows_line_ends.toml").find("\r\n"),
            std::string::npos);
}

// Generated here, as a repository is no place for megabytes.
TEST(BadScenes, OfHostileSizeAreRefusedInTime) {
  const TemporaryFolder folder;
  std::string deep_key = "a", deep_tables = "[a", fluids, keys = "[output]\n";
  for (int k = 0; k < 2000000; ++k) deep_key += ".a";
  for (int k = 0; k < 2000000; ++k) deep_tables += ".\"a\"";
  for (int k = 0; k < 60000; ++k) fluids += "[[fluid]]\n";
  for (int k = 0; k < 60000; ++k) keys += "key_" + std::to_string(k) + " = 1\n";
  const std::string texts[] = {
      deep_key + " = 1\n",       deep_key + " = 1\n=", deep_tables + "]\n", fluids, keys,
      std::string(17 << 20, '#')};
  for (const std::string& text : texts) {
    write_text(folder / "hostile.toml", text);
    const auto r = check((folder / "hostile.toml").string());
    EXPECT_FALSE(r.timed_out);
    EXPECT_EQ(r.code, 2) << text.substr(0, 40) << " ended by signal " << r.ended_by;
    EXPECT_LT(r.err.size(), 5000u) << text.substr(0, 40);
    EXPECT_NE(r.err.find("hostile.toml"), std::string::npos) << r.err;
  }
}

}  // namespace
}  // namespace freshet::test

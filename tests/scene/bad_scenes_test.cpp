// SPDX-License-Identifier: MIT
/// Every scene of tests/scenes/bad is rejected with the messages of its .expected file.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/files.h"
#include "cli/process.h"
#include "freshet/real.h"
#include "freshet/scene.h"
#include "mesh/triangle_mesh.h"
#include "scene/model/body_shape.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

constexpr double time_limit = 10;  // [s]; a hang is a failure

std::vector<std::string> scenes_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_dir / "tests/scenes" / folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

ProcessResult check(const std::string& scene) {
  return freshet({"check", scene}, {.directory = source_dir, .seconds = time_limit});
}

/// What this build lacks for the scene of this name; null if nothing.
const char* missing_for(const std::string& name) {
  const auto any = [&](std::initializer_list<const char*> starts) {
    return std::any_of(starts.begin(), starts.end(), [&](auto s) { return name.starts_with(s); });
  };
  if (name.ends_with("_float") && sizeof(Real) != sizeof(float)) return "32-bit numbers";
  if (any({"mesh_"}) && !reads_meshes()) return "Assimp";
  if (any({"body_", "joint_"}) && !moves_free_bodies()) return "Bullet";
  if (any({"without_bullet_"}) && moves_free_bodies()) return "the lack of Bullet";
  if (any({"without_meshoptimizer_"}) && simplifies_surfaces()) return "the lack of meshoptimizer";
  if (any({"body_function_", "function_", "probes_of_every_kind"}) && !reads_expressions())
    return "muParser";
  return nullptr;
}

/// Changes to the source folder: scenes name their files by paths relative to it.
class InSourceFolder {
 public:
  InSourceFolder() { fs::current_path(source_dir); }
  ~InSourceFolder() { fs::current_path(before_); }

 private:
  fs::path before_ = fs::current_path();
};

/// Exit code and messages of `freshet check`, computed by the library.
std::string checked(const std::string& scene) {
  try {
    std::string text = "0\n";
    for (const Diagnostic& d : scene_warnings(load_scene(scene))) text += d.text() + "\n";
    return text;
  } catch (const Error& e) {
    std::string text = e.kind() == Error::Kind::scene ? "2\n" : "1\n";
    for (const Diagnostic& d : e.diagnostics()) text += d.text() + "\n";
    return text;
  }
}

std::string expected_of(const std::string& name) {
  return read_text(source_dir / ("tests/scenes/bad/" + name + ".expected"));
}

TEST(BadScenes, AreRejectedWithTheirMessages) {
  const InSourceFolder here;
  int rejected = 0;
  for (const std::string& name : scenes_in("bad")) {
    if (missing_for(name)) continue;
    SCOPED_TRACE(name);
    EXPECT_EQ(checked("tests/scenes/bad/" + name + ".toml"), expected_of(name));
    ++rejected;
  }
  EXPECT_GT(rejected, 200);
}

// One scene of each kind: syntax, an unknown key, a wrong type, a range, a file, geometry, a
// method, a time step, a flow, warnings beside errors.
TEST(BadScenes, AreRejectedByTheProgram) {
  for (const char* name :
       {"syntax_unclosed_string", "syntax_invalid_utf8", "unknown_key_near",
        "type_number_is_string", "range_negative", "points_missing_file", "fluids_overlap",
        "wcsph_unused_keys", "inlet_no_direction", "several_more_than_shown"}) {
    SCOPED_TRACE(name);
    const auto r = check(std::string("tests/scenes/bad/") + name + ".toml");
    EXPECT_FALSE(r.timed_out);
    EXPECT_EQ(r.ended_by, 0) << "ended by a signal";
    EXPECT_EQ(std::to_string(r.code) + "\n" + r.err, expected_of(name));
    EXPECT_EQ(r.out, "");
  }
}

TEST(GoodScenes, Pass) {
  const InSourceFolder here;
  for (const std::string& name : scenes_in("good")) {
    if (missing_for(name)) continue;
    SCOPED_TRACE(name);
    const std::string text = checked("tests/scenes/good/" + name + ".toml");
    EXPECT_TRUE(text.starts_with("0\n")) << text;
    EXPECT_EQ(text.find("error"), std::string::npos) << text;
  }
  const auto r = check("tests/scenes/good/bom.toml");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(r.out.starts_with("tests/scenes/good/bom.toml: a good scene")) << r.out;
}

// Git or an editor could have changed them.
TEST(GoodScenes, HaveAByteOrderMarkAndWindowsLineEnds) {
  EXPECT_TRUE(read_text(source_dir / "tests/scenes/good/bom.toml").starts_with("\xEF\xBB\xBF"));
  EXPECT_NE(read_text(source_dir / "tests/scenes/good/windows_line_ends.toml").find("\r\n"),
            std::string::npos);
}

// Generated here, since the repository should not hold megabytes.
TEST(BadScenes, OfHostileSizeAreRejectedInTime) {
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

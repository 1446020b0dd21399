// SPDX-License-Identifier: MIT
/// The scenes of tests/scenes/wrong go wrong on purpose, or seem to. Each ends with the exit code
/// and the messages of its .expected file.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/files.h"
#include "cli/process.h"
#include "engine/select.h"
#include "freshet/real.h"
#include "freshet/scene.h"

namespace freshet::test {
namespace {

std::vector<std::string> wrong_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_dir / "tests/scenes/wrong"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

ProcessResult run_wrong(const std::string& name, const fs::path& output,
                        const std::vector<std::string>& more = {}) {
  std::vector<std::string> all{
      "run", "tests/scenes/wrong/" + name + ".toml", "--output", output.string(), "--threads", "1"};
  all.insert(all.end(), more.begin(), more.end());
  return freshet(all, {.directory = source_dir, .seconds = 120});
}

/// `words` with RUN in place of the run's folder.
std::string with_run(std::string words, const fs::path& folder) {
  const std::string path = folder.string();
  for (auto at = words.find(path); at != std::string::npos; at = words.find(path))
    words.replace(at, path.size(), "RUN");
  return words;
}

std::string state_in(const fs::path& file) {
  return Json::parse(read_text(file)).at("state").get<std::string>();
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return info.param; }

class WrongScene : public testing::TestWithParam<std::string> {};

TEST_P(WrongScene, EndsWithTheExpectedMessages) {
  if (sizeof(Real) != sizeof(float)) GTEST_SKIP() << "the messages contain 32-bit numbers";
  if (!has_solver(
          load_scene(source_dir / ("tests/scenes/wrong/" + GetParam() + ".toml")).solver.name))
    GTEST_SKIP() << "not compiled in this build";
  const TemporaryFolder folder;
  const std::string expected =
      read_text(source_dir / ("tests/scenes/wrong/" + GetParam() + ".expected"));
  const auto r = run_wrong(GetParam(), folder.path());
  EXPECT_FALSE(r.timed_out);
  EXPECT_EQ(r.ended_by, 0) << "ended by a signal";
  EXPECT_EQ(std::to_string(r.code) + "\n" + with_run(r.err, folder.path()), expected);
  EXPECT_EQ(state_in(folder / "manifest.json"), r.code == 0 ? "done" : "failed");
  EXPECT_TRUE(fs::exists(folder / "scene.toml"));
  if (fs::exists(folder / "report.json")) {
    EXPECT_EQ(state_in(folder / "report.json"), r.code == 0 ? "done" : "cannot be right");
    EXPECT_TRUE(fs::exists(folder / "result.png"));
  }
  expect_whole_run(folder.path());
}

INSTANTIATE_TEST_SUITE_P(Scenes, WrongScene, testing::ValuesIn(wrong_scenes()), name_of);

TEST(WrongScenes, KeepFramesWrittenBeforeTheFailure) {
  const TemporaryFolder folder;
  const auto r =
      run_wrong("step_ten_times_its_bound", folder.path(), {"--set", "output.frame_every_steps=3"});
  EXPECT_EQ(r.code, 1);
  for (const char* name : {"frames/frame_0000.png", "frames/frame_0001.png"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  expect_whole_run(folder.path());
}

// No checkpoint of a lost particle is written.
TEST(WrongScenes, NameThePictureAndTheLastGoodCheckpoint) {
  const TemporaryFolder folder;
  const auto r = run_wrong("step_ten_times_its_bound", folder.path(),
                           {"--set", "output.checkpoint_every_steps=1"});
  EXPECT_EQ(r.code, 1);
  std::set<std::string> checkpoints;
  for (const std::string& file : files_below(folder.path()))
    if (file.starts_with("checkpoints/")) checkpoints.insert(file);
  ASSERT_EQ(checkpoints.size(), 2u);
  const std::string words = with_run(r.err, folder.path());
  EXPECT_NE(words.find("; RUN/failure.png shows the moment; the last good checkpoint is RUN/" +
                       *checkpoints.rbegin() + "\n"),
            std::string::npos)
      << words;
  EXPECT_TRUE(fs::exists(folder / "failure.png"));
  expect_whole_run(folder.path());
}

TEST(WrongScenes, RunToTheEndIfWhenWrongIsWarn) {
  const TemporaryFolder folder;
  const auto r = run_wrong("stiffness_too_small", folder.path(),
                           {"--set", "checks.when_wrong=warn", "--quiet"});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(r.err.starts_with("error: the run cannot be right: ")) << r.err;
  const Json report = report_of(folder.path());
  EXPECT_EQ(report.at("state"), "cannot be right");
  EXPECT_EQ(report.at("time"), 2.0);
  const Json& warning = report.at("warnings").at(0);
  EXPECT_EQ(warning.at("kind"), "density");
  EXPECT_EQ(warning.at("cannot_be_right"), true);
  EXPECT_GT(warning.at("worst"), 1);
  EXPECT_LT(warning.at("first_step"), warning.at("last_step"));
}

TEST(WrongScenes, LogWarningsAsEvents) {
  const TemporaryFolder folder;
  const auto r = run_wrong("step_over_its_bound", folder.path(), {"--log", "json"});
  EXPECT_EQ(r.code, 0) << r.err;
  int warnings = 0;
  for (const std::string& line : lines_of(r.out)) {
    const Json event = Json::parse(line, nullptr, false);
    ASSERT_TRUE(event.is_object()) << line;
    if (event.at("event") != "warning" || event.at("kind") == "scene") continue;
    ++warnings;
    EXPECT_EQ(event.at("kind"), "time step");
    EXPECT_EQ(event.at("message"), report_of(folder.path()).at("warnings").at(0).at("message"));
  }
  EXPECT_EQ(warnings, 1);
}

}  // namespace
}  // namespace freshet::test

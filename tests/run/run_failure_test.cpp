// SPDX-License-Identifier: MIT
/// A run that fails says so in its manifest, whatever failed.
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "cli/files.h"
#include "freshet/run.h"
#include "io/run_folder.h"

namespace freshet::test {
namespace {

Scene small_scene() {
  return parse_scene(
      "domain.max = [1, 1]\nparticles.spacing = 0.1\nfluid = { min = [0, 0], max = [0.6, 0.4] }\n"
      "solver = { name = \"wcsph\", sound_speed = 30.0 }\ntime = { end = 0.01, step = 1e-3 }\n"
      "picture = { width = 64, height = 48 }\noutput.checkpoint_every_steps = 2\n",
      "small.toml");
}

RunOptions options_for(const fs::path& folder) {
  RunOptions options;
  options.output = folder;
  options.scene_name = "small";
  options.execution.threads = 1;
  return options;
}

Json manifest_of(const fs::path& folder) {
  return Json::parse(read_text(folder / "manifest.json"), nullptr, false);
}

TEST(RunFailure, OutOfMemoryIsAnErrorOfTheRun) {
  const TemporaryFolder folder;
  RunOptions options = options_for(folder / "run");
  options.after_step = [](const Simulation& sim, double) -> bool {
    if (sim.steps_done() == 5) throw std::bad_alloc();
    return true;
  };
  try {
    run(small_scene(), options);
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_EQ(Error::Kind::run, e.kind());
    const std::string words = e.what();
    EXPECT_TRUE(contains(words, "out of memory at step 5, 0.005 s; make particles.spacing larger"))
        << words;
    EXPECT_TRUE(contains(words, "failure.png shows the moment")) << words;
    EXPECT_TRUE(contains(words, "checkpoints/step_000000004.h5")) << words;
  }
  EXPECT_EQ("failed", manifest_of(folder / "run").at("state"));
  expect_whole_run(folder / "run");
}

TEST(RunFailure, ExceptionOfTheCallerIsRethrown) {
  const TemporaryFolder folder;
  RunOptions options = options_for(folder / "run");
  options.after_step = [](const Simulation&, double) -> bool { throw std::logic_error("mine"); };
  EXPECT_THROW(run(small_scene(), options), std::logic_error);
  EXPECT_EQ("failed", manifest_of(folder / "run").at("state"));
}

// A folder in the place of the temporary file makes each write of a file fail, as a full disk does.
TEST(RunFailure, RunThatCannotBeginLeavesNoManifest) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "run/scene.toml.part");
  EXPECT_THROW(run(small_scene(), options_for(folder / "run")), Error);
  EXPECT_FALSE(fs::exists(folder / "run/manifest.json"));
}

TEST(RunFailure, ManifestIsMarkedWhereItCannotBeReplaced) {
  const TemporaryFolder folder;
  RunFolder run(FolderLock::of_new(folder / "run"));
  run.take(RunFolder::Take::empty, {{"a", "b"}, {}},
           {{"freshet", "run \xff\n\"x\""}, "cpu", "plain", 1});
  const Json before = manifest_of(folder / "run");
  EXPECT_EQ("running", before.at("state"));
  EXPECT_EQ("run \xef\xbf\xbd\n\"x\"", before.at("command").at(1));
  fs::create_directory(folder / "run/manifest.json.part");
  run.write("a", "one");
  run.fail();
  Json after = manifest_of(folder / "run");
  ASSERT_TRUE(after.is_object()) << read_text(folder / "run/manifest.json");
  EXPECT_EQ("failed", after.at("state"));
  after["state"] = "running";
  EXPECT_EQ(before, after);
  fs::remove(folder / "run/manifest.json.part");
  run.fail();
  EXPECT_EQ(sha256("one"), manifest_of(folder / "run").at("files").at(0).at("sha256"));
}

TEST(RunFailure, ManifestOfAnotherRunIsNotMarked) {
  const TemporaryFolder folder;
  run(small_scene(), options_for(folder / "run"));
  EXPECT_THROW(run(small_scene(), options_for(folder / "run")), Error);
  EXPECT_EQ("done", manifest_of(folder / "run").at("state"));
  expect_whole_run(folder / "run");
}

}  // namespace
}  // namespace freshet::test

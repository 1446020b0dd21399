// SPDX-License-Identifier: MIT
/// The folder of a run: its files, and the files that a run must not change.
#include <gtest/gtest.h>

#include <csignal>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

/// The contents of every file below a folder, by name.
std::map<std::string, std::string> snapshot(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& file : files_below(folder)) all[file] = read_text(folder / file);
  return all;
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& words) {
  const auto r = freshet(arguments);
  EXPECT_EQ(r.code, 2) << r.err;
  EXPECT_TRUE(contains(r.err, words)) << r.err;
}

TEST(RunFolder, MatchesItsManifest) {
  const TemporaryFolder folder;
  const auto r = freshet(short_run(folder.path(), {"--set", "checks.height_mean_max=3"}));
  EXPECT_EQ(r.code, 0) << r.err;
  expect_whole_run(folder.path());
  const auto files = files_below(folder.path());
  for (const char* file : {"frames/frame_0000.png", "frames/frame_0001.png", "result.png",
                           "report.json", "observables.csv", "scene.toml"})
    EXPECT_TRUE(files.contains(file)) << file;
  const Json manifest = Json::parse(read_text(folder / "manifest.json"));
  EXPECT_EQ(manifest.at("state"), "done");
  for (const char* key : {"freshet", "commit", "compiler", "isa", "threads", "command"})
    EXPECT_TRUE(manifest.contains(key)) << key;
  EXPECT_EQ(report_of(folder.path()).at("steps"), 50);
}

TEST(RunFolder, HoldsAnExactCopyOfTheScene) {
  const TemporaryFolder folder;
  const std::string scene = (source_dir / "tests/scenes/good/windows_line_ends.toml").string();
  const auto r = freshet({"run", scene, "--output", folder.path().string()});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(read_text(folder / "scene.toml"), read_text(scene));
}

TEST(RunFolder, HoldsTheSceneWithItsOverrides) {
  const TemporaryFolder folder;
  const std::string title = "two\nlines = 1, ''' and \"\"\" and \x1b[31m";
  auto arguments = short_run(folder / "a", {"--set", "title=" + title});
  freshet(arguments);
  const Json first = report_of(folder / "a");
  EXPECT_EQ(first.at("title"), title);
  EXPECT_TRUE(contains(read_text(folder / "a/scene.toml"), "end = 0.05"));

  const auto again =
      freshet({"run", (folder / "a/scene.toml").string(), "--output", (folder / "b").string()});
  EXPECT_EQ(again.err.find("--set"), std::string::npos) << again.err;
  const Json second = report_of(folder / "b");
  EXPECT_EQ(second.at("title"), title);
  EXPECT_EQ(second.at("state_sha256"), first.at("state_sha256"));
}

TEST(RunFolder, IsNotChangedWithoutOverwrite) {
  const TemporaryFolder folder;
  freshet(short_run(folder.path()));
  const auto before = snapshot(folder.path());
  expect_refused(short_run(folder.path(), {"--set", "particles.seed=2"}), "--overwrite");
  EXPECT_EQ(snapshot(folder.path()), before);
}

TEST(RunFolder, KeepsForeignFilesWhenOverwritten) {
  const TemporaryFolder folder;
  freshet(short_run(folder.path(), {"--set", "output.frame_every_steps=5"}));
  write_text(folder / "notes.txt", "mine");
  write_text(folder / "frames/holiday.png", "mine too");
  EXPECT_TRUE(fs::exists(folder / "frames/frame_0009.png"));
  const auto r = freshet(short_run(folder.path(), {"--overwrite"}));
  EXPECT_FALSE(contains(r.err, "error: this")) << r.err;
  EXPECT_FALSE(fs::exists(folder / "frames/frame_0009.png"));  // listed in the first manifest
  EXPECT_EQ(read_text(folder / "notes.txt"), "mine");
  EXPECT_EQ(read_text(folder / "frames/holiday.png"), "mine too");
}

TEST(RunFolder, IsRejectedIfAForeignFileWouldBeReplaced) {
  const TemporaryFolder folder;
  write_text(folder / "result.png", "my picture");
  for (const bool overwrite : {false, true}) {
    auto arguments = short_run(folder.path());
    if (overwrite) arguments.push_back("--overwrite");
    expect_refused(arguments, "result.png: error: ");
    EXPECT_EQ(files_below(folder.path()), std::set<std::string>{"result.png"});
    EXPECT_EQ(read_text(folder / "result.png"), "my picture");
  }
}

// A run cannot know the steps of its checkpoints before, but it must not replace or rotate others'.
TEST(RunFolder, IsRejectedIfItHoldsCheckpointsOfOthers) {
  for (const char* name : {"checkpoints/step_000000050.h5", "checkpoints/step_999999999.h5",
                           "checkpoints/step_000000050.h5.part", "failure.png"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    freshet(short_run(folder / "old"));
    write_text(folder / "old" / name, "mine");
    write_text(folder / "new" / name, "mine");
    const auto old = snapshot(folder / "old"), fresh = snapshot(folder / "new");
    expect_refused(short_run(folder / "new"), "this file was not written by a run");
    if (std::string(name) != "checkpoints/step_000000050.h5" &&
        std::string(name) != "checkpoints/step_000000050.h5.part")  // the old run's own
      expect_refused(short_run(folder / "old", {"--overwrite"}),
                     (folder / "old" / name).string() + ": error: this file was not written");
    EXPECT_EQ(snapshot(folder / "old"), old);
    EXPECT_EQ(snapshot(folder / "new"), fresh);
  }
  const TemporaryFolder folder;
  write_text(folder / "checkpoints/notes.txt", "mine");
  EXPECT_EQ(freshet(short_run(folder.path(), {"--set", "checks.height_mean_max=3"})).code, 0);
  EXPECT_EQ(read_text(folder / "checkpoints/notes.txt"), "mine");
}

TEST(RunFolder, WritesAndDeletesNothingThroughALink) {
  for (const char* name : {"frames", "checkpoints", "data"}) {
    SCOPED_TRACE(name);
    const std::vector<std::string> data{"--set", "output.data=[\"csv\"]"};
    const TemporaryFolder folder;
    freshet(short_run(folder / "run", data));
    fs::rename(folder / "run" / name, folder / "outside");
    fs::create_directory_symlink("../outside", folder / "run" / name);
    fs::create_directories(folder / "new");
    fs::create_directory_symlink("../outside", folder / "new" / name);
    const auto outside = snapshot(folder / "outside"), run = snapshot(folder / "run");
    ASSERT_FALSE(outside.empty());
    auto over = data;
    over.push_back("--overwrite");
    expect_refused(short_run(folder / "run", over),
                   (folder / "run" / name).string() + ": error: this is a symbolic link");
    expect_refused(short_run(folder / "new", data),
                   (folder / "new" / name).string() + ": error: this is a symbolic link");
    EXPECT_EQ(snapshot(folder / "outside"), outside);
    EXPECT_EQ(snapshot(folder / "run"), run);
    if (std::string(name) != "data") continue;
    // a run without data files does not need the folder, whose files the manifest names
    const auto r = freshet(short_run(folder / "run", {"--overwrite", "--set", "output.data=[]"}));
    EXPECT_FALSE(contains(r.err, "symbolic link")) << r.err;
    EXPECT_EQ(snapshot(folder / "outside"), outside);
  }
}

TEST(RunFolder, ReplacesPlantedLinksToFiles) {
  const TemporaryFolder folder;
  const std::vector<std::string> names{"result.png.part", "scene.toml.part", "manifest.json.part",
                                       "frames/frame_0000.png.part"};
  const auto plant = [&](const fs::path& run) {
    for (const std::string& name : names) {
      fs::create_directories((run / name).parent_path());
      fs::create_symlink(folder / "victim", run / name);
    }
  };
  write_text(folder / "victim", "precious");
  freshet(short_run(folder / "run"));
  plant(folder / "run");
  const auto r =
      freshet(short_run(folder / "run", {"--overwrite", "--set", "checks.height_mean_max=3"}));
  EXPECT_EQ(r.code, 0) << r.err;
  expect_whole_run(folder / "run");
  plant(folder / "new");  // no run wrote them there
  expect_refused(short_run(folder / "new"), "this file was not written by a run");
  EXPECT_EQ(read_text(folder / "victim"), "precious");
}

TEST(RunFolder, ForgedManifestDeletesNothingOutside) {
  const TemporaryFolder folder;
  const std::string victim = (folder / "victim.txt").string();
  const Json names = {"../victim.txt",
                      victim,
                      "frames/../../victim.txt",
                      "./../victim.txt",
                      "..",
                      ".",
                      "",
                      "frames//../..//victim.txt"};
  Json entries = names;
  for (const Json& name : names) entries.push_back({{"file", name}});
  write_text(victim, "precious");
  write_text(folder / "run/manifest.json", Json{{"files", entries}}.dump());
  freshet(short_run(folder / "run", {"--overwrite", "--quiet"}));
  EXPECT_EQ(read_text(victim), "precious");
  expect_whole_run(folder / "run");
}

TEST(RunFolder, IsRejectedWithAnInvalidManifest) {
  for (const char* text : {"", "[]", "3", "{", "{\"files\": 3}", "{\"files\": [3]}",
                           "{\"files\": [{\"file\": 3}]}", "null"}) {
    const TemporaryFolder folder;
    write_text(folder / "manifest.json", text);
    expect_refused(short_run(folder.path(), {"--overwrite"}), "not a manifest");
    EXPECT_EQ(read_text(folder / "manifest.json"), text);
  }
}

TEST(RunFolder, IsLockedByItsRun) {
  const TemporaryFolder folder;
  Process first(freshet_command(long_run(folder.path())));
  ASSERT_TRUE(first.wait_for("particles"));
  expect_refused(short_run(folder.path()), "another run");
  expect_refused(short_run(folder.path(), {"--overwrite"}), "another run");
  first.send(SIGINT);
  EXPECT_EQ(first.finish().code, 130);
  expect_whole_run(folder.path());
}

TEST(RunFolder, ReportsThatItCannotBeCreated) {
  const TemporaryFolder folder;
  write_text(folder / "file", "mine");
  for (const std::string& output :
       {std::string("/dev/full"), std::string("/proc/no/such"), (folder / "file").string(),
        (folder / "file/below").string(), (folder / std::string(300, 'x')).string()}) {
    const auto r = freshet(short_run(output));
    EXPECT_EQ(r.code, 1) << output;
    EXPECT_TRUE(contains(r.err, output + ": error: cannot make this folder: ")) << r.err;
    EXPECT_TRUE(contains(r.err, "--output")) << r.err;
  }
  EXPECT_EQ(read_text(folder / "file"), "mine");
}

TEST(RunFolder, HasNoPartialFilesOnAFullDisk) {
  const std::uint64_t below_a_picture = 20000, below_a_manifest = 50;
  for (const std::uint64_t limit : {below_a_picture, below_a_manifest}) {
    const TemporaryFolder folder;
    const auto r = freshet(short_run(folder.path()), {.file_limit = limit});
    EXPECT_EQ(r.code, 1) << r.err;
    EXPECT_EQ(r.ended_by, 0);
    EXPECT_TRUE(contains(r.err, "error: cannot write: ") && contains(r.err, "ulimit -f")) << r.err;
    for (const std::string& file : files_below(folder.path()))
      EXPECT_FALSE(file.ends_with(".part")) << file;
    EXPECT_FALSE(fs::exists(folder / "result.png"));
    if (limit == below_a_picture) {
      expect_whole_run(folder.path());
      EXPECT_EQ(Json::parse(read_text(folder / "manifest.json")).at("state"), "failed");
    }
  }
}

TEST(RunFolder, OfAKilledRunCanBeOverwritten) {
  const TemporaryFolder folder;
  Process killed(freshet_command(long_run(folder.path())));
  ASSERT_TRUE(killed.wait_for("particles"));
  killed.send(SIGKILL);
  EXPECT_EQ(killed.finish().ended_by, SIGKILL);
  expect_refused(short_run(folder.path()), "--overwrite");
  const auto r = freshet(short_run(folder.path(), {"--overwrite"}));
  EXPECT_FALSE(contains(r.err, "choose another")) << r.err;
  for (const std::string& file : files_below(folder.path()))
    EXPECT_FALSE(file.ends_with(".part")) << file;
  expect_whole_run(folder.path());
}

}  // namespace
}  // namespace freshet::test

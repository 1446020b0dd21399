// SPDX-License-Identifier: MIT
/// `freshet resume` continues runs that were interrupted, killed, damaged or out of disk space.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include "cli/files.h"
#include "cli/process.h"
#include "cli/resume.h"

namespace freshet::test {
namespace {

// Kills 5 runs, or FRESHET_KILLS of them, at random times. A kill before the first checkpoint or
// after the end does not count.
TEST_F(Resume, GivesTheSameRunAfterAKillAtAnyMoment) {
  const std::vector<std::string> longer{"--set", "time.end=0.8", "--threads", "1"};
  const double start = now();
  ASSERT_EQ(freshet(arguments("whole", longer)).code, 0);
  const double seconds = now() - start;
  const char* asked = std::getenv("FRESHET_KILLS");
  const int kills = asked ? std::atoi(asked) : 5;
  std::minstd_rand random(7);
  int resumed = 0;
  for (int k = 0; resumed < kills && k < 6 * kills; ++k) {
    const std::string name = "killed" + std::to_string(k);
    const double moment = seconds * std::uniform_real_distribution<>(0.02, 0.98)(random);
    Process killed(freshet_command(arguments(name, longer)));
    std::this_thread::sleep_for(std::chrono::duration<double>(moment));
    killed.send(SIGKILL);
    killed.finish();
    if (fs::exists(folder / name / "report.json")) continue;  // the run had ended
    const auto r = resume(name);
    if (checkpoints(name).empty()) {
      EXPECT_EQ(r.code, 2) << r.err;
      continue;
    }
    ++resumed;
    ASSERT_EQ(r.code, 0) << r.err << " killed after " << moment << " s";
    expect_same_run("whole", name);
    fs::remove_all(folder / name);
  }
  EXPECT_EQ(resumed, kills);
}

TEST_F(Resume, GivesTheSameStateAfterCtrlC) {
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  const auto r = freshet(arguments("cut", {"--set", "time.end=30", "--log", "json"}),
                         {.signal = SIGINT, .signal_after = "progress"});
  ASSERT_EQ(r.code, 130) << r.err;
  expect_whole_run(folder / "cut");
  EXPECT_EQ(report_of(folder / "cut").at("state"), "interrupted");
  ASSERT_FALSE(checkpoints("cut").empty());
  const std::int64_t steps = report_of(folder / "cut").at("steps");
  EXPECT_TRUE(contains(checkpoints("cut").back().string(), std::to_string(steps)));
  // the new end is 40 steps later
  const std::string end = "time.end=" + std::to_string(double(steps + 40) * 0.0005);
  const auto on = resume("cut", {"--set", end});
  EXPECT_EQ(on.code, 0) << on.err;
  ASSERT_EQ(freshet(arguments("long", {"--set", end})).code, 0);
  EXPECT_EQ(report_of(folder / "cut").at("state_sha256"),
            report_of(folder / "long").at("state_sha256"));
}

TEST_F(Resume, ExtendedRunEqualsALongerRun) {
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  ASSERT_EQ(freshet(arguments("short", {"--set", "time.end=0.1"})).code, 0);
  const auto at_end = resume("short");
  EXPECT_EQ(at_end.code, 2);
  EXPECT_TRUE(contains(at_end.err, "has reached its end, 0.1 s; --set time.end=")) << at_end.err;
  const auto r = resume("short", {"--set", "time.end=0.25"});
  ASSERT_EQ(r.code, 0) << r.err;
  expect_same_run("whole", "short");
}

TEST_F(Resume, RejectsAnEndBeforeTheMomentOfTheRun) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  for (const bool killed : {false, true}) {
    if (killed) fs::remove(folder / "run/report.json");  // after the last checkpoint
    const auto before = read_text(folder / "run/scene.toml");
    for (const char* end : {"0.05", "0.0995"}) {
      const auto r = resume("run", {"--set", std::string("time.end=") + end});
      EXPECT_EQ(r.code, 2) << r.out;
      EXPECT_TRUE(contains(r.err,
                           "--set time.end: error: time.end must be later than 0.1 s, which the "
                           "run has reached"))
          << r.err;
    }
    EXPECT_EQ(before, read_text(folder / "run/scene.toml"));
  }
  const auto end = resume("run", {"--set", "time.end=0.1"});  // writes what the killed run lacks
  EXPECT_EQ(end.code, 0) << end.err;
  expect_whole_run(folder / "run");
}

// A resume that is killed before its first checkpoint leaves the new end in scene.toml only.
TEST_F(Resume, KeepsTheEndOfAnEarlierResume) {
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  const fs::path file = folder / "run/scene.toml";
  std::string text = read_text(file);
  text.replace(text.find("end = 0.1"), 9, "end = 0.25");
  write_text(file, text);
  fs::remove(folder / "run/report.json");
  const auto r = resume("run");
  ASSERT_EQ(r.code, 0) << r.err;
  expect_same_run("whole", "run");
}

TEST_F(Resume, RejectsACheckpointOfAnotherScene) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  ASSERT_EQ(
      freshet(arguments("other", {"--set", "time.end=0.2", "--set", "domain.gravity=[0.0, -1.6]"}))
          .code,
      0);
  const fs::path foreign = checkpoints("other").back();
  for (const std::string& name : {foreign.filename().string(), std::string("step_000000200.h5")}) {
    SCOPED_TRACE(name);
    const fs::path copy = folder / "run/checkpoints" / name, own = folder / "own";
    if (fs::exists(copy)) fs::rename(copy, own);
    fs::copy_file(foreign, copy);
    const auto before = files_below(folder / "run");
    const std::string report = read_text(folder / "run/report.json");
    const auto r = resume("run", {"--set", "time.end=0.25"});
    EXPECT_EQ(r.code, 2) << r.err;
    const std::string scene_file = (folder / "run/scene.toml").string();
    EXPECT_TRUE(contains(r.err, copy.string() +
                                    ": error: this checkpoint is of another scene: "
                                    "domain.gravity differs from " +
                                    scene_file))
        << r.err;
    EXPECT_EQ(before, files_below(folder / "run"));
    EXPECT_EQ(report, read_text(folder / "run/report.json"));
    fs::remove(copy);
    if (fs::exists(own)) fs::rename(own, copy);
  }
  const auto r = resume("run", {"--set", "time.end=0.25"});
  EXPECT_EQ(r.code, 0) << r.err;
}

// Of the same scene, so that only the manifest shows that the run did not write it.
TEST_F(Resume, NeitherUsesNorRemovesACheckpointOfOthers) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  const fs::path copy = folder / "run/checkpoints/step_000000150.h5";
  fs::copy_file(checkpoints("run").front(), copy);
  const std::string bytes = read_text(copy), manifest = read_text(folder / "run/manifest.json");
  const auto r = resume("run", {"--set", "time.end=0.25"});
  EXPECT_EQ(r.code, 2) << r.err;
  EXPECT_TRUE(contains(r.err, copy.string() + ": error: this file was not written by a run"))
      << r.err;
  EXPECT_EQ(bytes, read_text(copy));
  EXPECT_EQ(manifest, read_text(folder / "run/manifest.json"));
  fs::remove(copy);
  EXPECT_EQ(resume("run", {"--set", "time.end=0.25"}).code, 0);
}

TEST_F(Resume, WritesThroughNoLink) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  for (const char* name : {"observables.csv", "frames"}) {
    SCOPED_TRACE(name);
    fs::rename(folder / "run" / name, folder / "outside");
    fs::create_symlink(folder / "outside", folder / "run" / name);
    const auto before = fs::is_directory(folder / "outside")
                            ? std::to_string(files_below(folder / "outside").size())
                            : read_text(folder / "outside");
    const auto r = resume("run", {"--set", "time.end=0.25"});
    EXPECT_EQ(r.code, 2) << r.err;
    EXPECT_TRUE(contains(r.err, (folder / "run" / name).string() + ": error: this is a symbolic "
                                                                   "link"))
        << r.err;
    EXPECT_EQ(before, fs::is_directory(folder / "outside")
                          ? std::to_string(files_below(folder / "outside").size())
                          : read_text(folder / "outside"));
    fs::remove(folder / "run" / name);
    fs::rename(folder / "outside", folder / "run" / name);
  }
  EXPECT_EQ(resume("run", {"--set", "time.end=0.25"}).code, 0);
}

TEST_F(Resume, UsesTheCheckpointBeforeADamagedOne) {
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  for (const bool torn : {true, false}) {
    const std::string name = torn ? "torn" : "damaged";
    ASSERT_EQ(freshet(arguments(name, {"--set", "time.end=0.1"})).code, 0);
    ASSERT_EQ(checkpoints(name).size(), 2u) << "a run keeps its last two checkpoints";
    const fs::path newest = checkpoints(name).back();
    std::string bytes = read_text(newest);
    if (torn) bytes.resize(bytes.size() / 3);
    else bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 4);
    write_text(newest, bytes);
    const auto r = resume(name, {"--set", "time.end=0.25"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.err, newest.string() + ": warning: this checkpoint is " + name))
        << r.err;
    EXPECT_TRUE(contains(r.err, "; going on from step 180")) << r.err;
    expect_same_run("whole", name);
  }
}

TEST_F(Resume, FailsWithoutAnIntactCheckpointAndChangesNothing) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  for (const fs::path& file : checkpoints("run")) write_text(file, "nothing");
  const auto before = read_text(folder / "run/manifest.json");
  const auto r = resume("run", {"--set", "time.end=0.25"});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "step_000000200.h5: error: this is no checkpoint")) << r.err;
  EXPECT_TRUE(contains(r.err, "step_000000180.h5: error: this is no checkpoint")) << r.err;
  EXPECT_EQ(before, read_text(folder / "run/manifest.json"));
}

TEST_F(Resume, RejectsAFolderWithoutARun) {
  fs::create_directories(folder / "empty");
  const auto none = resume("empty");
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "this folder holds no run")) << none.err;
  const auto nowhere = resume("nowhere");
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_TRUE(contains(nowhere.err, "/nowhere: error: there is no such folder")) << nowhere.err;
  EXPECT_FALSE(contains(nowhere.err, "--output")) << nowhere.err;
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
  const auto file = resume("scene.toml");
  EXPECT_EQ(file.code, 2);
  EXPECT_TRUE(contains(file.err, "not a folder")) << file.err;
}

TEST_F(Resume, RejectsChangesOfTheSimulation) {
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  for (const char* change : {"particles.spacing=0.1", "time.step=0.001", "solver.backend=reference",
                             "fluid.viscosity=1", "time.ending=2"}) {
    const auto r = resume("run", {"--set", change});
    EXPECT_EQ(r.code, 2) << change;
    const std::string key = std::string(change).substr(0, std::string(change).find('='));
    EXPECT_TRUE(contains(r.err, "--set " + key + ": error: this changes what has been simulated"))
        << r.err;
  }
  const auto typo = resume("run", {"--set", "output.frame_evry=1"});
  EXPECT_EQ(typo.code, 2);
  EXPECT_TRUE(contains(typo.err, "did you mean output.frame_every")) << typo.err;
}

// The disk is full while a checkpoint is written. Earlier checkpoints stay, and the run resumes
// from them when there is space again.
TEST_F(Resume, ContinuesAfterAFullDisk) {
  // enough particles that the file limit exceeds what the thread sanitizer itself writes
  const auto many = [](const std::string& end) {
    return std::vector<std::string>{
        "--set", "particles.spacing=0.0035",         "--set", "time.step=0.00002",
        "--set", "output.checkpoint_every_steps=10", "--set", "time.end=" + end};
  };
  ASSERT_EQ(freshet(arguments("whole", many("0.0006"))).code, 0);
  ASSERT_EQ(freshet(arguments("full", many("0.0004"))).code, 0);
  const auto before = checkpoints("full");
  const std::uint64_t limit = fs::file_size(before.back()) / 2;
  ASSERT_GT(limit, 600'000u);
  std::vector<std::string> on{"resume", (folder / "full").string(), "--set", "time.end=0.0006"};
  const auto r = freshet(on, {.file_limit = limit});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "error: cannot write: ")) << r.err;
  EXPECT_TRUE(contains(r.err, "the last good checkpoint is " + before.back().string())) << r.err;
  EXPECT_EQ(before, checkpoints("full"));
  const auto again = freshet(on);
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(report_of(folder / "full").at("state_sha256"),
            report_of(folder / "whole").at("state_sha256"));
}

// HDF5 refuses to open a file in memory if the working directory has a file of its name.
TEST_F(Resume, IsIndependentOfFilesInTheWorkingDirectory) {
  write_text(folder / "freshet", "the name of the program");
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.02"})).code, 0);
  const auto r = freshet({"resume", (folder / "run").string(), "--set", "time.end=0.03"},
                         {.directory = folder.path()});
  EXPECT_EQ(r.code, 0) << r.err;
}

TEST_F(Resume, NeedsNoFileOutsideTheRunFolder) {
  std::string points = "x,y\n";
  for (int k = 0; k < 40; ++k)
    points +=
        std::to_string(0.1 + 0.05 * (k % 8)) + "," + std::to_string(0.1 + 0.05 * (k / 8)) + "\n";
  write_text(folder / "points.csv", points);
  std::string text = resumable_scene;
  text.replace(text.find("min = [0.0, 0.0]\nmax = [0.4, 0.6]"), 33,
               "shape = \"points\"\nfile = \"points.csv\"");
  write_text(folder / "scene.toml", text);
  const auto first = freshet(arguments("run", {"--set", "time.end=0.1"}));
  ASSERT_EQ(first.code, 0) << first.err;
  fs::remove(folder / "points.csv");
  fs::rename(folder / "run", folder / "elsewhere");
  const auto r = resume("elsewhere", {"--set", "time.end=0.12"});
  EXPECT_EQ(r.code, 0) << r.err;
  expect_whole_run(folder / "elsewhere");
  const auto again = freshet(
      {"run", (folder / "elsewhere/scene.toml").string(), "--output", (folder / "again").string()});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(report_of(folder / "again").at("state_sha256"),
            report_of(folder / "elsewhere").at("state_sha256"));
  // overwrites the folder that contains the file of points
  const auto over = freshet({"run", (folder / "elsewhere/scene.toml").string(), "--output",
                             (folder / "elsewhere").string(), "--overwrite"});
  EXPECT_EQ(over.code, 0) << over.err;
  expect_whole_run(folder / "elsewhere");
}

}  // namespace
}  // namespace freshet::test

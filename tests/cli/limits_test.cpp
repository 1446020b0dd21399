// SPDX-License-Identifier: MIT
/// Runs that meet a limit of the machine: threads, memory, the size of files.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

std::string manifest_state(const fs::path& folder) {
  return Json::parse(read_text(folder / "manifest.json")).at("state").get<std::string>();
}

TEST(Limits, TooManyThreadsAreRejectedBeforeAnythingStarts) {
  const TemporaryFolder folder;
  const std::string run = (folder / "run").string();
  const std::vector<std::vector<std::string>> commands{
      {"run", article, "--output", run, "--threads", "100000"},
      {"info", article, "--threads", "100000"},
      {"bench", article, "--threads", "100000"},
      {"render", run, "--threads", "100000"},
      {"validate", "dam_break_front", "--output", run, "--jobs", "100000"}};
  for (const auto& command : commands) {
    const auto r = freshet(command);
    EXPECT_EQ(r.code, 2) << command[0];
    EXPECT_EQ(r.out, "") << command[0];
    const std::string option = command[command.size() - 2];
    EXPECT_TRUE(contains(r.err, option + " 100000: error: at most ")) << command[0] << r.err;
    EXPECT_FALSE(fs::exists(run)) << command[0];
  }
}

TEST(Limits, ThreadsThatTheSystemDoesNotStartAreAnError) {
  if (sanitized) GTEST_SKIP() << "the sanitizers need more address space";
  const TemporaryFolder folder;
  // the stacks of 64 threads take more than this
  const std::string scene = (source_dir / "tests/scenes/good/plain.toml").string();
  const auto r = freshet({"run", scene, "--output", (folder / "run").string(), "--threads", "64"},
                         {.memory_limit = std::uint64_t(200) << 20});
  EXPECT_EQ(r.code, 1) << r.ended_by;
  EXPECT_TRUE(contains(r.err, "--threads 64: error: ")) << r.err;
  EXPECT_TRUE(contains(r.err, "ulimit")) << r.err;
  EXPECT_FALSE(fs::exists(folder / "run"));
}

// The memory of this run grows: an inlet brings particles, and pictures are large.
constexpr const char* growing_scene = R"([domain]
max = [4.0, 1.4]
[particles]
spacing = 0.04
[[inlet]]
center = [0.2, 0.8]
direction = [1, 0]
width = 0.6
speed = 2.4
[solver]
name = "wcsph"
sound_speed = 30
[time]
end = 0.04
step = 0.0004
[output]
frame_every = 0.02
checkpoint_every = 0.02
data = []
[picture]
width = 1600
height = 560
)";

TEST(Limits, MemoryThatRunsOutEndsARunWithAnError) {
  if (sanitized) GTEST_SKIP() << "the sanitizers need more address space";
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", growing_scene);
  int failed = 0;
  bool done = false;
  for (std::uint64_t limit = 64; limit < 1024 && !done; limit += 2) {  // [MiB]
    const fs::path run = folder / ("run" + std::to_string(limit));
    const auto r = freshet({"run", (folder / "scene.toml").string(), "--output", run.string(),
                            "--threads", "2", "--quiet"},
                           {.memory_limit = limit << 20});
    if (r.code == 127) continue;  // the program itself is larger
    done = r.code == 0;
    EXPECT_TRUE(r.code == 0 || r.code == 1)
        << limit << ": " << r.code << " " << r.ended_by << r.err;
    if (!fs::exists(run / "manifest.json")) continue;
    EXPECT_EQ(manifest_state(run), done ? "done" : "failed") << limit;
    if (done) continue;
    ++failed;
    EXPECT_TRUE(contains(r.err, "error: ")) << limit << ": " << r.err;
    EXPECT_TRUE(contains(r.err, "memory")) << limit << ": " << r.err;
  }
  EXPECT_TRUE(done);
  EXPECT_GT(failed, 0);
}

// Each limit makes another write fail: of the manifest, of the scene before the first step, later
// ones.
TEST(Limits, FilesThatCannotGrowEndARunWithAnError) {
  const TemporaryFolder folder;
  write_text(folder / "scene.toml", "# " + std::string(4000, '.') + "\n" + growing_scene);
  int failed = 0;
  for (const std::uint64_t limit : {400, 1000, 1600, 2200, 3000, 5000}) {  // [B]
    const fs::path run = folder / std::to_string(limit);
    const auto r =
        freshet({"run", (folder / "scene.toml").string(), "--output", run.string(), "--quiet"},
                {.file_limit = limit});
    EXPECT_EQ(r.code, 1) << limit << r.err;
    if (!fs::exists(run / "manifest.json")) continue;
    ++failed;
    EXPECT_EQ(manifest_state(run), "failed") << limit;
    EXPECT_TRUE(contains(r.err, "error: cannot write: ")) << r.err;
  }
  EXPECT_GT(failed, 0);
}

}  // namespace
}  // namespace freshet::test

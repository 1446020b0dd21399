// SPDX-License-Identifier: MIT
/// What the program prints: on descriptors that are closed or full, and without control characters.
#include <gtest/gtest.h>

#include <csignal>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {
namespace {

/// A short run that prints warnings to stderr and succeeds.
std::vector<std::string> run_with_a_warning(const fs::path& output) {
  return short_run(output, {"--set", "checks.height_mean_max=3"});
}

TEST(Streams, RunIsCompleteWithoutStderr) {
  const TemporaryFolder folder;
  const auto seen = freshet(run_with_a_warning(folder / "seen"));
  ASSERT_EQ(seen.code, 0) << seen.err;
  ASSERT_TRUE(contains(seen.err, "warning: ")) << seen.err;
  const auto full = freshet(run_with_a_warning(folder / "full"), {.stderr_file = "/dev/full"});
  EXPECT_EQ(full.code, 0) << full.ended_by;
  expect_whole_run(folder / "full");
  const auto gone = freshet(run_with_a_warning(folder / "gone"), {.close_stderr_early = true});
  EXPECT_EQ(gone.code, 0) << gone.ended_by;
  expect_whole_run(folder / "gone");
}

TEST(Streams, ErrorsKeepTheirExitCodeWithoutStderr) {
  for (const ProcessOptions& options :
       {ProcessOptions{.stderr_file = "/dev/full"}, ProcessOptions{.closed = {2}}})
    for (const auto& command :
         {std::vector<std::string>{"check", "nowhere.toml"}, std::vector<std::string>{"run"},
          std::vector<std::string>{"check", article, "--set", "time.end=-1"}}) {
      const auto r = freshet(command, options);
      EXPECT_EQ(r.code, 2) << command[0] << r.ended_by;
    }
}

// Without /dev/null in their place, files of the run would get the numbers of these descriptors.
TEST(Streams, ClosedDescriptorsDoNotReachFiles) {
  const std::vector<std::vector<int>> cases{{1}, {2}, {1, 2}, {0, 1, 2}};
  for (const auto& closed : cases) {
    const TemporaryFolder folder;
    const auto r = freshet(run_with_a_warning(folder / "run"), {.closed = closed});
    EXPECT_EQ(r.code, 0) << r.ended_by;
    expect_whole_run(folder / "run");
  }
}

TEST(Streams, ReportUnwritableStdout) {
  for (const char* command : {"schema", "--help", "scenes", "validate", "manual"}) {
    const auto full = freshet({command}, {.stdout_file = "/dev/full"});
    EXPECT_EQ(full.code, 1) << command;
    EXPECT_TRUE(contains(full.err, "standard output: No space left on device")) << full.err;
    const auto closed = freshet({command}, {.closed = {1}});
    EXPECT_EQ(closed.code, 1) << command;
    EXPECT_TRUE(contains(closed.err, "standard output: Bad file descriptor")) << closed.err;
    const auto gone = freshet({command}, {.close_stdout_early = true});
    EXPECT_EQ(gone.code, 0) << command << gone.ended_by;
    EXPECT_EQ(gone.err, "") << command;
  }
}

TEST(Streams, HangupEndsARunAsCtrlCDoes) {
  const TemporaryFolder folder;
  Process process(freshet_command(long_run(folder.path())));
  ASSERT_TRUE(process.wait_for("particles"));
  process.send(SIGHUP);
  process.send(SIGHUP);  // a terminal that closes may send it twice
  const auto r = process.finish();
  EXPECT_EQ(r.code, 130) << r.err << r.ended_by;
  expect_whole_run(folder.path());
  EXPECT_EQ(report_of(folder.path()).at("state"), "interrupted");
  EXPECT_TRUE(fs::exists(folder / "checkpoints"));
}

TEST(Streams, HangupIsIgnoredWithNohup) {
  const TemporaryFolder folder;
  const std::vector<std::string> command{
      "sh",
      "-c",
      "trap '' HUP; exec \"$0\" run \"$1\" --output \"$2\" --set "
      "time.end=3 --set checks.height_mean_max=3",
      FRESHET_PROGRAM,
      article,
      folder.path().string()};
  const auto r = run_process(command, {.signal = SIGHUP, .signal_after = "particles"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(report_of(folder.path()).at("state"), "done");
}

bool has_control_characters(const std::string& text) {
  return text.find_first_of("\x1b\x7f\x07\r") != std::string::npos || contains(text, "\xc2\x9b");
}

TEST(Streams, TextOfAScenePrintsEscapes) {
  const TemporaryFolder folder;
  const fs::path scene = folder / "red.toml";
  write_text(scene, "title = \"A\\u001b[31mred\\nline\\u009b\\u007f\\u0007 \u00e9\"\n" +
                        read_text(source_dir / "tests/scenes/good/plain.toml"));
  const auto info = freshet({"info", scene.string()});
  EXPECT_EQ(info.code, 0) << info.err;
  EXPECT_TRUE(info.out.starts_with("A\\x1b[31mred\\nline\\u009b\\x7f\\x07 \u00e9\n")) << info.out;
  const auto run = freshet({"run", scene.string(), "--output", (folder / "run").string()});
  EXPECT_EQ(run.code, 0) << run.err;
  const auto error = freshet({"check", scene.string(), "--set", "time.\x1b[31m=1"});
  EXPECT_EQ(error.code, 2);
  const auto name = freshet({"check", "a\x1b[31m\xc2\x9b\n.toml"});
  EXPECT_TRUE(name.err.starts_with("a\\x1b[31m\\u009b\\n.toml: error: ")) << name.err;
  for (const auto& r : {info, run, error, name}) {
    EXPECT_FALSE(has_control_characters(r.out)) << r.out;
    EXPECT_FALSE(has_control_characters(r.err)) << r.err;
  }
}

TEST(Streams, NamesThatAreNotUtf8AreReplacedInJson) {
  const TemporaryFolder folder;
  const fs::path scene = folder / "pond\xff.toml", output = folder / "out\xff";
  fs::copy_file(source_dir / "tests/scenes/good/plain.toml", scene);
  const auto r = freshet({"run", scene.string(), "--output", output.string(), "--log", "json"});
  ASSERT_EQ(r.code, 0) << r.err;
  for (const std::string& line : lines_of(r.out))
    EXPECT_TRUE(Json::parse(line, nullptr, false).is_object()) << line;
  EXPECT_EQ(report_of(output).at("scene"), "pond\xef\xbf\xbd");
  expect_whole_run(output);
  const auto on = freshet({"resume", output.string(), "--set", "time.end=0.02"});
  EXPECT_EQ(on.code, 0) << on.err;
  EXPECT_EQ(report_of(output).at("scene"), "pond\xef\xbf\xbd");
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
/// Tables that a resumed run continues.
#include "cli/resume.h"

namespace freshet::test {
namespace {

// A checkpoint knows how long each table was and its digest; the rows are in the folder only.
TEST_F(Resume, ChecksTheTablesThatItContinues) {
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  const fs::path table = folder / "run/observables.csv";
  const std::string rows = read_text(table);
  std::string changed = rows;
  changed[rows.size() / 2] = changed[rows.size() / 2] == '1' ? '2' : '1';
  for (const std::string& bad : {changed, rows.substr(0, rows.size() / 2)}) {
    write_text(table, bad);
    const auto r = resume("run", {"--set", "time.end=0.25"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, table.string() + ": error: this table was changed after the run "
                                                 "wrote it; put it back, or move it away"))
        << r.err;
    EXPECT_EQ(bad, read_text(table));
  }
  write_text(table, rows + "200,0.1,a row that a killed ru");
  const auto r = resume("run", {"--set", "time.end=0.25"});
  ASSERT_EQ(r.code, 0) << r.err;
  expect_same_run("whole", "run");
}

TEST_F(Resume, BeginsAMissingTableAgain) {
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  const fs::path table = folder / "run/observables.csv";
  fs::remove(table);
  const auto r = resume("run", {"--set", "time.end=0.25"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.err, table.string() + ": warning: this table is missing")) << r.err;
  const std::string rows = read_text(table), all = read_text(folder / "whole/observables.csv");
  const std::size_t header = all.find('\n') + 1;
  EXPECT_EQ(rows.substr(0, header), all.substr(0, header));
  EXPECT_TRUE(all.ends_with(rows.substr(header)));
  EXPECT_TRUE(rows.substr(header).starts_with("204,")) << rows.substr(header, 20);
}

/// Statistics since the last row, and frames within steps, with a resume between two rows.
TEST_F(Resume, ContinuesStatisticsAndInterpolatedFrames) {
  std::string scene = resumable_scene;
  const std::string steps = "frame_every_steps = 33\n";
  scene.replace(scene.find(steps), steps.size(),
                "frame_every = 0.0123\nstatistics = true\ndata = [\"csv\"]\n");
  write_text(folder / "scene.toml", scene + "[[probe]]\nname = \"p\"\nat = [0.1, 0.05]\n");
  ASSERT_EQ(freshet(arguments("whole")).code, 0);
  ASSERT_EQ(freshet(arguments("run", {"--set", "time.end=0.1"})).code, 0);
  const auto r = resume("run", {"--set", "time.end=0.25"});
  ASSERT_EQ(r.code, 0) << r.err;
  expect_same_run("whole", "run");
  const std::string header = read_text(folder / "run/observables.csv");
  EXPECT_TRUE(contains(header, ",force on y_min y max [N/m],")) << header.substr(0, 400);
  EXPECT_TRUE(contains(read_text(folder / "run/data/frame_0001.csv"), "25,0.0123,0,"));
}

TEST_F(Resume, ContinuesTablesWithNamesInOtherAlphabets) {
  const std::string scene =
      (source_dir / "tests/scenes/good/names_in_other_alphabets.toml").string();
  const fs::path whole = folder / "whole", run = folder / "run";
  const auto start = [&](const fs::path& output, const char* end) {
    return freshet({"run", scene, "--output", output.string(), "--set", end, "--set",
                    "output.frame_every_steps=50"});
  };
  ASSERT_EQ(start(whole, "time.end=0.01").code, 0);
  ASSERT_EQ(start(run, "time.end=0.005").code, 0);
  ASSERT_EQ(freshet({"resume", run.string(), "--set", "time.end=0.01"}).code, 0);
  expect_whole_run(run);
  const std::string probe = "probes/前壁-1.csv";
  EXPECT_EQ(read_text(run / probe), read_text(whole / probe));
  const std::string header = lines_of(read_text(run / "observables.csv")).at(0);
  EXPECT_TRUE(contains(header, ",force on Überlauf links x [N/m],")) << header;
  EXPECT_TRUE(contains(header, ",flow through 計数面 [m^2/s],")) << header;
}

}  // namespace
}  // namespace freshet::test

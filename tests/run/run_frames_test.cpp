// SPDX-License-Identifier: MIT
#include "freshet/run_frames.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "freshet/run.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

TEST(RunFrames, ReadsTheDataFilesOfARun) {
  const fs::path folder = fs::path(testing::TempDir()) / "freshet_run_frames";
  fs::remove_all(folder);
  const Scene scene = parse_scene(R"(
domain = { max = [1, 1] }
particles = { spacing = 0.1 }
fluid = { min = [0, 0], max = [0.3, 0.5] }
solver = { name = "wcsph", sound_speed = 20 }
time = { end = 0.02, step = 0.001 }
output = { data_every_steps = 10, data = ["hdf5"] }
)",
                                  "column.toml");
  RunOptions options;
  options.output = folder;
  run(scene, options);
  const RunFrames frames(folder);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames.scene().dimension(), 2);
  EXPECT_EQ(frames.file(1).filename(), "frame_0001.h5");
  const Frame frame = frames.read(1);
  EXPECT_NEAR(double(frame.step), 10, 1);
  EXPECT_NEAR(frame.time, 0.01, 0.0011);
  EXPECT_EQ(frame.size(), 15u);
  EXPECT_THROW(frames.read(3), std::out_of_range);
  EXPECT_THROW(RunFrames(folder / "data"), Error);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace freshet

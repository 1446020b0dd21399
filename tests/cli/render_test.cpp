// SPDX-License-Identifier: MIT
/// `freshet render` draws pictures of a finished run.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "cli/process.h"
#include "io/frame_data.h"
#include "render/png.h"

namespace freshet::test {
namespace {

/// Writes a finished run of three frames; its two particles move apart.
void make_run(const fs::path& folder) {
  write_text(folder / "scene.toml",
             "domain.max = [2, 1]\nparticles.spacing = 0.1\ntime = { end = 2, step = 1e-3 }\n"
             "fluid = { min = [0, 0], max = [1, 0.5] }\npicture = { width = 64, height = 32 }\n");
  for (int k = 0; k < 3; ++k) {
    Frame frame;
    frame.step = k;
    frame.time = 0.1 * k;
    frame.id = {0, 1};
    frame.x = {0.9f - 0.2f * float(k), 0.5f, 1.1f + 0.2f * float(k), 0.5f};
    frame.v = {1, 0, 0, 0};
    frame.density = frame.pressure = {0, 0};
    write_text(folder / data_file(DataFormat::vtp, k), encode_vtp(frame));
  }
}

class Render : public testing::Test {
 protected:
  Render() { make_run(run); }
  ProcessResult render(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"render", run.string()});
    return freshet(more);
  }
  void expect_refused(const ProcessResult& r, const std::string& words) {
    EXPECT_EQ(r.code, 2);
    EXPECT_NE(r.err.find(words), std::string::npos) << r.err;
  }
  static Image picture(const fs::path& file) { return decode_png(read_text(file)); }
  TemporaryFolder folder;
  fs::path run = folder.path();
};

TEST_F(Render, DrawsEveryFrameOfARun) {
  const auto r = render();
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_NE(r.out.find("3 pictures"), std::string::npos) << r.out;
  EXPECT_EQ(picture(run / "pictures/frame_0002.png").width, 64);
  EXPECT_NE(read_text(run / "pictures/frame_0000.png"), read_text(run / "pictures/frame_0002.png"));
  EXPECT_FALSE(fs::exists(run / "pictures/frame_0003.png"));
}

TEST_F(Render, AppliesPictureSettings) {
  EXPECT_EQ(render().code, 0);
  const auto r = render({"--set", "picture.width=100", "--set", "picture.color_by=id", "--output",
                         (folder / "other").string(), "--quiet"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(picture(folder / "other/frame_0000.png").width, 100);
}

TEST_F(Render, RejectsOtherAndInvalidSettings) {
  expect_refused(render({"--set", "time.end=3"}), "--set time.end: error: the run is over");
  expect_refused(render({"--set", "picture.color_by=heat"}), "picture.color_by is the string");
  expect_refused(render({"--set", "camera.orbit=3"}), "a camera needs a scene in 3D");
  EXPECT_FALSE(fs::exists(run / "pictures"));
}

TEST_F(Render, ReplacesPicturesOnlyWithOverwrite) {
  EXPECT_EQ(render().code, 0);
  expect_refused(render(), "--overwrite replaces them");
  EXPECT_EQ(render({"--overwrite"}).code, 0);
}

TEST_F(Render, RejectsARunWithoutData) {
  fs::remove_all(run / "data");
  expect_refused(render(), "this run wrote no data to draw");
  fs::remove(run / "scene.toml");
  expect_refused(render(), "no run is in this folder");
}

TEST_F(Render, VideoIsAsLongAsTheRun) {
  const std::string film = (folder / "film.mp4").string();
  if (run_process({"ffprobe", "-version"}).code != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const auto r = render({"--video", film, "--fps", "50"});
  EXPECT_EQ(r.code, 0) << r.err;
  const auto frames = run_process({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=nb_read_frames", "-of", "csv=p=0", film});
  EXPECT_EQ(frames.out.substr(0, 2), "11");  // 0.2 s at 50 frames/s, and the last frame
}

}  // namespace
}  // namespace freshet::test

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
             "fluid = { min = [0, 0], max = [1, 0.5] }\npicture = { width = 64, height = 32, "
             "color_range = [0, 1] }\n");
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
  expect_refused(render({"--set", "camera.orbit=3"}),
                 "--set camera.orbit: error: a camera needs a scene in 3D");
  EXPECT_FALSE(fs::exists(run / "pictures"));
}

TEST_F(Render, MakesAVideoWithoutPictures) {
  const std::string film = (folder / "film.gif").string();
  const auto r = render({"--no-pictures", "--video", film, "--fps", "10"});
  if (r.code == 2 && contains(r.err, "ffmpeg")) GTEST_SKIP() << r.err;
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "3 pictures") && contains(r.out, "wrote " + film)) << r.out;
  EXPECT_TRUE(fs::exists(film));
  EXPECT_FALSE(fs::exists(run / "pictures"));
  expect_refused(render({"--no-pictures"}),
                 "--no-pictures: error: neither pictures nor a video are to be made; name a file "
                 "with --video");
}

TEST_F(Render, DrawsWaterFromPositionsAlone) {
  expect_refused(render({"--set", "picture.style=water"}),
                 "picture.style = \"water\" needs a scene in 3D");  // make_run's is in 2D
  write_text(run / "scene.toml",
             "domain.max = [2, 1, 1]\nparticles.spacing = 0.1\ntime = { end = 2, step = 1e-3 }\n"
             "fluid = { min = [0, 0, 0], max = [1, 0.5, 1] }\npicture.width = 64\n");
  Frame frame;
  frame.dimension = 3;
  frame.id = {0, 1};
  frame.x = {0.9f, 0.5f, 0.5f, 1.1f, 0.5f, 0.5f};
  DataFields fields;
  fields.velocity = fields.density = fields.pressure = false;
  for (int k = 0; k < 3; ++k)
    write_text(run / data_file(DataFormat::vtp, k), encode_vtp(frame, fields));
  const ProcessResult r = render({"--set", "picture.style=water"});
  EXPECT_EQ(r.code, 0) << r.err;
}

TEST_F(Render, RejectsAColorWhoseFieldIsMissing) {
  Frame frame;
  frame.id = {0, 1};
  frame.x = {0.9f, 0.5f, 1.1f, 0.5f};
  DataFields fields;
  fields.velocity = fields.density = fields.pressure = false;
  for (int k = 0; k < 3; ++k)
    write_text(run / data_file(DataFormat::vtp, k), encode_vtp(frame, fields));
  expect_refused(render({"--set", "picture.color_by=pressure"}),
                 (run / data_file(DataFormat::vtp, 0)).string() +
                     ": error: this data file has no pressure, which picture.color_by needs");
  expect_refused(render(), "this data file has no velocity");
  EXPECT_EQ(render({"--set", "picture.color_by=height"}).code, 0);
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

TEST_F(Render, GivesPicturesTheNumbersOfTheirDataFiles) {
  write_text(run / data_file(DataFormat::vtp, 5), read_text(run / data_file(DataFormat::vtp, 1)));
  EXPECT_EQ(render({"--output", (folder / "whole").string(), "--quiet"}).err, "");
  fs::remove(run / data_file(DataFormat::vtp, 0));
  fs::remove(run / data_file(DataFormat::vtp, 1));
  const auto r = render();
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.err, (run / "data").string() +
                                  ": warning: data files are missing: 0000 to 0001, 0003 to 0004; "
                                  "they get no picture"))
      << r.err;
  EXPECT_EQ((std::set<std::string>{"frame_0002.png", "frame_0005.png"}),
            files_below(run / "pictures"));
  for (const char* name : {"frame_0002.png", "frame_0005.png"})
    EXPECT_EQ(read_text(folder / "whole" / name), read_text(run / "pictures" / name));
}

TEST_F(Render, WritesNothingThroughALinkInTheRun) {
  fs::create_directories(folder / "outside");
  fs::create_directory_symlink("outside", run / "pictures");
  const auto r = render({"--overwrite"});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "a symbolic link is in the way")) << r.err;
  EXPECT_TRUE(fs::is_empty(folder / "outside"));
  const auto named = render({"--output", (run / "pictures").string()});  // the user's choice
  EXPECT_EQ(named.code, 0) << named.err;
  EXPECT_EQ(files_below(folder / "outside").size(), 3u);
}

TEST(RenderRun, HasThePicturesOfTheRunAlsoOfAPartOfIt) {
  const TemporaryFolder folder;
  const std::string run = (folder / "run").string();
  ASSERT_EQ(freshet({"run", "dam_break_2d", "--set", "particles.spacing=0.1", "--set",
                     "particles.support_radius=0.3", "--set", "checks.density_mean_min=0", "--set",
                     "time.end=0.6", "--set", "output.frame_every=0.1", "--set",
                     "output.data=[\"vtp\"]", "--output", run, "--quiet"})
                .code,
            0);
  const auto same = [&](const std::string& name) {
    return read_text(folder / "run/frames" / name) == read_text(folder / "run/pictures" / name);
  };
  ASSERT_EQ(freshet({"render", run, "--quiet"}).code, 0);
  for (const char* name : {"frame_0000.png", "frame_0002.png", "frame_0006.png"})
    EXPECT_TRUE(same(name)) << name;
  for (int k = 0; k < 4; ++k) fs::remove(folder / "run" / data_file(DataFormat::vtp, k));
  fs::remove_all(folder / "run/pictures");
  ASSERT_EQ(freshet({"render", run, "--quiet"}).code, 0);
  EXPECT_TRUE(same("frame_0005.png"));

  fs::remove(folder / "run/percentiles.csv");
  const auto r = freshet({"render", run, "--overwrite"});
  EXPECT_EQ(r.code, 0);
  EXPECT_TRUE(contains(r.err, "percentiles.csv: warning: this table is missing")) << r.err;
}

/// A run with a body, whose table has the steps 0, 1 and 2 from line 2 on.
class RenderBodies : public Render {
 protected:
  RenderBodies() {
    write_text(run / "scene.toml",
               read_text(run / "scene.toml") +
                   "solver.name = \"wcsph\"\n[[body]]\nname = \"box\"\nmin = [1.4, 0.2]\n"
                   "max = [1.7, 0.5]\nmotion = \"fixed\"\n");
    write_text(table, header + row(0, "1.4") + row(1, "1.5") + row(2, "1.6"));
  }
  static std::string row(int step, const std::string& x) {
    return std::to_string(step) + ",0." + std::to_string(step) + ",box," + x + ",0.35,0,0,0,0,1" +
           ",0,0,0,0,0,0,0,0,0" + ",0,0,0\n";
  }
  void expect_error(const std::string& bytes, const std::string& place, const std::string& words) {
    write_text(table, bytes);
    const auto r = render({"--overwrite"});
    expect_refused(r, place + ": error: " + words);
    EXPECT_TRUE(contains(r.err, "run the scene again")) << r.err;
  }
  const fs::path table = run / "bodies.csv";
  const std::string header =
      "step,time [s],body,x [m],y [m],z [m],qx,qy,qz,qw,velocity x [m/s],velocity y [m/s],"
      "velocity z [m/s],angular velocity x [rad/s],angular velocity y [rad/s],"
      "angular velocity z [rad/s],force x [N/m],force y [N/m],force z [N/m],torque x [N m/m],"
      "torque y [N m/m],torque z [N m/m]\n";
};

TEST_F(RenderBodies, DrawsThemWhereTheTableHasThem) {
  const auto r = render();
  ASSERT_EQ(r.code, 0) << r.err;
  const std::string first = read_text(run / "pictures/frame_0001.png");
  write_text(table, header + row(0, "1.4") + row(1, "1.2") + row(2, "1.6"));
  ASSERT_EQ(render({"--overwrite"}).code, 0);
  EXPECT_NE(first, read_text(run / "pictures/frame_0001.png"));
}

TEST_F(RenderBodies, RejectsAMissingOrDamagedTable) {
  const std::string start = header + row(0, "1.4");
  expect_error(start + row(1, "nan") + row(2, "1.6"), table.string() + ":3",
               "the value in column 4 is not a finite number");
  expect_error(start + "1,0.1\n" + row(2, "1.6"), table.string() + ":3", "this line has 2 values");
  expect_error(row(0, "1.4") + row(1, "1.5"), table.string() + ":1",
               "the first line does not name the columns");
  expect_error(start + row(2, "1.6"), table.string(), "there is no row for each body at 0.1 s");
  expect_error(start + row(1, "1.5") + row(2, "1.6").substr(0, 20), table.string(),
               "there is no row for each body at 0.2 s");
  fs::remove(table);
  expect_refused(render({"--overwrite"}), table.string() + ": error: this table is missing");
}

TEST_F(Render, VideoIsAsLongAsTheRun) {
  const std::string film = (folder / "film.mp4").string();
  if (run_process({"ffprobe", "-version"}).code != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const auto r = render({"--video", film, "--fps", "50"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "\nwrote " + film + "\n")) << r.out;
  const auto frames = run_process({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=nb_read_frames", "-of", "csv=p=0", film});
  EXPECT_EQ(frames.out.substr(0, 2), "11");  // 0.2 s at 50 frames/s, and the last frame
}

}  // namespace
}  // namespace freshet::test

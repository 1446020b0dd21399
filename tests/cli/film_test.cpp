// SPDX-License-Identifier: MIT
/// `freshet film`, with a script in the place of Blender.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "cli/cubes.h"
#include "cli/process.h"
#include "render/png.h"
#include "run/body_table.h"

namespace freshet::test {
namespace {

/// Checks the arguments as Blender gets them and copies picture.png, which stands beside it. Adds
/// them to the file `arguments`.
constexpr const char* good_blender = R"sh(#!/bin/sh
here=$(dirname "$0")
printf '%s\n' "$@" >> "$here/arguments"
for file in "${11}/scene.json" "${11}/${12}" "${9}"; do
  [ -f "$file" ] || { echo "no $file"; exit 3; }
done
[ "$(cat)" = "" ] || exit 4
cp "$here/picture.png" "${13}"
)sh";

class FilmCommand : public testing::Test {
 protected:
  FilmCommand() {
    make_cubes(run);
    use_blender(good_blender);
    write_text(folder / "bin/picture.png", encode_png(Image(64, 36, {1, 2, 3})));
  }
  void use_blender(const std::string& script) {
    write_text(folder / "bin/blender", script);
    fs::permissions(folder / "bin/blender", fs::perms::owner_all);
  }
  ProcessResult film(std::vector<std::string> more = {}, ProcessOptions how = {}) {
    more.insert(more.begin(), {"film", run.string(), "--size", "64x36", "--samples", "3"});
    how.environment.push_back("PATH=" + (folder / "bin").string() + ":/usr/bin:/bin");
    return freshet(more, how);
  }
  void expect_refused(const ProcessResult& r, const std::string& words) {
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, words)) << r.err;
  }
  std::set<std::string> pictures() { return files_below(run / "film"); }
  TemporaryFolder folder;
  fs::path run = folder / "run";
};

/// The JSON of a *.glb file.
Json document_of(const std::string& glb) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, 4);
  return Json::parse(glb.substr(20, size));
}

TEST_F(FilmCommand, RendersEveryFrame) {
  const auto r = film({"--threads", "2"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "3 pictures in ")) << r.out;
  EXPECT_EQ(pictures(),
            (std::set<std::string>{"frame_0000.png", "frame_0001.png", "frame_0002.png"}));
  EXPECT_FALSE(fs::exists(run / "film/scene"));
  const Image image = decode_png(read_text(run / "film/frame_0001.png"));
  EXPECT_EQ(image.at(5, 5), (Color{1, 2, 3}));
  const auto words = lines_of(read_text(folder / "bin/arguments"));
  ASSERT_EQ(words.size(), 39);
  EXPECT_EQ(std::vector<std::string>(words.begin(), words.begin() + 9),
            (std::vector<std::string>{"-b", "-noaudio", "--factory-startup", "--python-exit-code",
                                      "3", "-t", "2", "-P", words[8]}));
  EXPECT_TRUE(words[8].ends_with("integrations/blender/render_film.py")) << words[8];
  EXPECT_EQ(words[9], "--");
}

TEST_F(FilmCommand, WritesTheSceneThatBlenderReads) {
  write_text(run / "scene.toml",
             read_text(run / "scene.toml") +
                 "[[wall]]\nname = \"post\"\nshape = \"cylinder\"\ncenter = [1.5, 1, 1.5]\n"
                 "radius = 0.2\naxis = [0, 1, 0]\nlength = 2\n[[body]]\nname = \"ball\"\n"
                 "shape = \"sphere\"\ncenter = [1.5, 1.5, 0.5]\nradius = 0.3\n");
  const Scene loaded = load_scene(run / "scene.toml");
  std::string table = body_header(loaded);
  for (const double time : {0.0, 0.1, 0.2}) {
    Frame moment;
    moment.time = time;
    moment.bodies = {{.position = {1.5, 1.5 - 2.5 * time, 0.5}}};
    table += body_lines(moment, loaded);
  }
  write_text(run / "bodies.csv", table);
  const auto r = film({"--at", "0.12", "--keep", "--set", "camera.position=[1, 2, 5]", "--set",
                       "camera.target=[1, 1, 1]"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(pictures(),
            (std::set<std::string>{"frame_0001.png", "scene/body0.glb", "scene/frame_0001.json",
                                   "scene/liquid0_0001.glb", "scene/liquid1_0001.glb",
                                   "scene/scene.json", "scene/wall0.glb"}));
  const fs::path scene = run / "film/scene";
  const Json all = Json::parse(read_text(scene / "scene.json"));
  EXPECT_EQ(all["width"], 64);
  EXPECT_EQ(all["height"], 36);
  EXPECT_EQ(all["samples"], 3);
  EXPECT_EQ(all["denoise"], false);
  EXPECT_EQ(all["domain"]["max"], Json({2, 2, 2}));
  EXPECT_EQ(all["walls_of_domain"], Json({false, false, false, false, false, false}));
  EXPECT_EQ(all["format"], 2);
  EXPECT_EQ(all["shutter"], 0.004);
  EXPECT_NEAR(all["seen"]["max"][0], 1.5 + 0.3 / 2, 0.2);
  EXPECT_EQ(all["liquids"].size(), 2);
  EXPECT_EQ(all["liquids"][1]["rest_density"], 800);
  EXPECT_EQ(all["bodies"][0]["name"], "ball");
  EXPECT_EQ(all["walls"][0]["mesh"], "wall0.glb");
  const Json frame = Json::parse(read_text(scene / "frame_0001.json"));
  EXPECT_EQ(frame["time"], 0.1);
  EXPECT_EQ(frame["camera"]["position"], Json({1, 2, 5}));
  EXPECT_EQ(frame["camera"]["target"], Json({1, 1, 1}));
  EXPECT_EQ(frame["surfaces"], Json({"liquid0_0001.glb", "liquid1_0001.glb"}));
  EXPECT_EQ(frame["bodies"][0]["position"], Json({1.5, 1.25, 0.5}));
  const Json ball = document_of(read_text(scene / "body0.glb"));
  const auto& corner = ball["accessors"][0]["max"];
  EXPECT_NEAR(corner[1], 0.3, 1e-6);  // about its centre
  EXPECT_EQ(ball["nodes"][0]["name"], "ball");
  const Json liquid = document_of(read_text(scene / "liquid1_0001.glb"));
  EXPECT_GT(liquid["accessors"][0]["count"], 100);
}

TEST_F(FilmCommand, WritesOnlyTheSceneWithoutBlender) {
  Frame frame;
  frame.dimension = 3;
  frame.whitewater = {{7}, {1, 1, 1}, {0, 0, 0}, {1}, {0.5f}};
  write_text(run / "data/whitewater_0001.ply", encode_ply(whitewater_table(frame)));
  const auto only = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"film", run.string(), "--scene-only"});
    return freshet(more, {.environment = {"PATH=/nowhere"}});
  };
  const auto r = only({"--material", "liquid1=milk", "--shutter", "0.02"});
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "3 frames in ")) << r.out;
  EXPECT_TRUE(contains(r.out, "wrote " + (run / "film/scene/frame_0002.json").string())) << r.out;
  const fs::path scene = run / "film/scene";
  const Json all = Json::parse(read_text(scene / "scene.json"));
  EXPECT_EQ(all["shutter"], 0.02);
  EXPECT_EQ(all["liquids"][1]["scattering"], 1);
  EXPECT_EQ(all["liquids"][0]["scattering"], 0);
  const auto foam = [&](int k) {
    return Json::parse(read_text(scene / fmt::format("frame_{:04}.json", k)))["whitewater"];
  };
  EXPECT_EQ(foam(0), Json::array());
  EXPECT_EQ(foam(1), Json::array({"whitewater_0001.ply"}));
  EXPECT_TRUE(contains(read_text(scene / "whitewater_0001.ply"), "element vertex 1\n"));
  expect_refused(only({}), "this folder holds scenes for Blender; --overwrite replaces them");
  expect_refused(only({"--overwrite", "--material", "liquid=mlik"}),
                 "--material liquid=mlik: error: unknown material \"mlik\"");
}

TEST_F(FilmCommand, TakesChosenFrames) {
  ASSERT_EQ(film({"--every", "2", "--quiet"}).out, "");
  EXPECT_EQ(pictures(), (std::set<std::string>{"frame_0000.png", "frame_0002.png"}));
  ASSERT_EQ(film({"--at", "0.16", "--output", (folder / "f").string()}).code, 0);
  EXPECT_EQ(files_below(folder / "f"), (std::set<std::string>{"frame_0002.png"}));
  expect_refused(film({"--at", "3"}), "--at 3: error: the data files of this run end at 0.2 s");
  expect_refused(film({"--overwrite", "--set", "particles.spacing=0.2"}), "only keys of [camera]");
  expect_refused(film(), "this folder holds pictures; --overwrite replaces them");
  expect_refused(freshet({"film", run.string(), "--size", "64x"}),
                 "--size 64x: error: write WIDTH");
  expect_refused(freshet({"film", run.string(), "--size", "4x4"}), "it must be from 16 to 8192");
}

TEST_F(FilmCommand, MakesAVideo) {
  const fs::path file = folder / "film.gif";
  const auto r = film({"--video", file.string()});
  if (r.code == 2 && contains(r.err, "ffmpeg")) GTEST_SKIP() << r.err;
  ASSERT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(read_text(file).substr(0, 4), "GIF8");
}

TEST_F(FilmCommand, NeedsBlender) {
  const auto r = freshet({"film", run.string()}, {.environment = {"PATH=/nowhere"}});
  expect_refused(r, "on Debian: sudo apt-get install blender");
  EXPECT_FALSE(fs::exists(run / "film"));
}

TEST_F(FilmCommand, ReportsTheEndOfBlendersOutput) {
  use_blender("#!/bin/sh\necho first\necho 'no space on this disk' >&2\nexit 3\n");
  const auto r = film();
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err,
                       "frame_0000.png: error: Blender could not render this picture: the "
                       "end of its output is: first | no space on this disk"))
      << r.err;
  EXPECT_TRUE(pictures().empty());
  const auto expect_error = [&](const std::string& script, const std::string& words) {
    use_blender("#!/bin/sh\n" + script);
    const std::string err = film().err;
    EXPECT_TRUE(contains(err, words)) << err;
  };
  expect_error("exit 0\n", "it wrote no picture");
  expect_error("echo garbage > \"${13}\"\n", "its picture is damaged");
  expect_error("kill -9 $$\n", "it ended early");
  EXPECT_TRUE(pictures().empty());
}

TEST_F(FilmCommand, StopsBlenderWhenItIsInterrupted) {
  use_blender("#!/bin/sh\nkill -INT $PPID\nexec sleep 20\n");
  const auto r = film();
  EXPECT_EQ(r.code, 130) << r.err;  // 1 if it waited: then no picture was written
  EXPECT_TRUE(pictures().empty());
}

TEST_F(FilmCommand, RejectsRunsWithoutALiquidIn3D) {
  make_cubes(run, true);
  expect_refused(film(), "scene.toml: error: this run is in 2D; a film needs a run in 3D");
  make_cubes(run);
  fs::remove_all(run / "data");
  expect_refused(film(), "this run wrote no data to make a film of");
  fs::remove(run / "scene.toml");
  expect_refused(film(), "no run is in this folder");
}

TEST_F(FilmCommand, LeavesNoPartOfAFileThatDoesNotFit) {
  const auto r = film({"--threads", "1"}, {.file_limit = 3000});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "limit on file sizes")) << r.err;
  EXPECT_TRUE(pictures().empty());
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// The window of `freshet view`, on a display of Xvfb.
#include <gtest/gtest.h>

#include <optional>

#include "freshet/simulation.h"
#include "render/draw.h"
#include "render/png.h"
#include "view/display.h"

namespace freshet {
namespace {

using namespace freshet::test;

class ViewWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!FRESHET_WINDOW)
      GTEST_SKIP()
          << "GLFW and Dear ImGui are not installed (libglfw3-dev, libimgui-dev): there is "
             "no window to test";
    if (!has_program("Xvfb"))
      GTEST_SKIP() << "Xvfb is not installed (xvfb, libgl1-mesa-dri): the window is not tested";
    display_.emplace();
  }
  ProcessOptions on_display(double seconds = 60) const {
    return {.environment = {"LIBGL_ALWAYS_SOFTWARE=1", "DISPLAY=" + display_->name},
            .seconds = seconds};
  }
  /// `freshet view` with these arguments.
  ProcessResult view(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "view");
    return test::freshet(arguments, on_display());
  }
  std::string scene(int dimension) const {
    const fs::path file = folder_ / ("red" + std::to_string(dimension) + "d.toml");
    write_text(file, red_scene(dimension));
    return file.string();
  }
  TemporaryFolder folder_;
  std::optional<Display> display_;
};

/// The number of red pixels of `a` that are farther than 2 px from every red pixel of `b`.
int pixels_apart(const Image& a, const Image& b) {
  constexpr int reach = 2;
  int apart = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (!is_red(a.at(x, y))) continue;
      bool near = false;
      for (int dy = -reach; dy <= reach && !near; ++dy)
        for (int dx = -reach; dx <= reach && !near; ++dx)
          near = b.holds(x + dx, y + dy) && is_red(b.at(x + dx, y + dy));
      apart += !near;
    }
  return apart;
}

TEST_F(ViewWindow, SilhouetteIsThatOfThePicturesOfARun) {
  for (const int dimension : {2, 3}) {
    SCOPED_TRACE(dimension);
    const std::string file = scene(dimension), png = folder_ / "window.png";
    Simulation sim(load_scene(file));
    for (int k = 0; k < 100; ++k) sim.step();
    const Image picture = draw(sim.scene(), sim.frame());
    const ProcessResult r =
        view({file, "--steps", "100", "--screenshot", png, "--width", std::to_string(picture.width),
              "--height", std::to_string(picture.height)});
    ASSERT_EQ(r.code, 0) << r.err;
    const Image window = decode_png(read_text(png));
    ASSERT_EQ(window.width, picture.width);
    ASSERT_EQ(window.height, picture.height);
    EXPECT_EQ(pixels_apart(window, picture), 0);
    EXPECT_EQ(pixels_apart(picture, window), 0);
    int red = 0;
    for (const Color c : window.pixels) red += is_red(c);
    EXPECT_GT(red, 1000);
  }
}

TEST_F(ViewWindow, DigestIsThatOfARunWithoutAWindow) {
  const std::string file = scene(2);
  Simulation sim(load_scene(file));
  for (int k = 0; k < 60; ++k) sim.step();
  const ProcessResult r = view({file, "--steps", "60", "--pictures", "8", "--report"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "state_sha256 " + sim.state_sha256())) << r.out;
}

TEST_F(ViewWindow, ClosesInTheMiddleOfARun) {
  const ProcessResult r =
      view({scene(2), "--play", "--speed", "0", "--set", "particles.spacing=0.01", "--set",
            "time.step=0.0001", "--pictures", "12", "--report"});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.out, "state_sha256")) << r.out;
  EXPECT_FALSE(contains(r.out, "step 10000,")) << "it was closed before the end: " << r.out;
}

TEST_F(ViewWindow, WaterIsDrawnOverTheFloor) {
  const std::string file = scene(3), balls = folder_ / "balls.png", water = folder_ / "water.png";
  ASSERT_EQ(view({file, "--screenshot", balls}).code, 0);
  const ProcessResult r = view({file, "--style", "water", "--screenshot", water});
  ASSERT_EQ(r.code, 0) << r.err;
  const Image picture = decode_png(read_text(water)), red = decode_png(read_text(balls));
  int blue = 0, reds = 0, outside = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Color c = picture.at(x, y);
      const bool liquid = c.b > c.r + 40 && c.g > c.r + 20;
      blue += liquid;
      reds += is_red(red.at(x, y));
      bool near = false;
      for (int d = -8; d <= 8 && !near; ++d)
        near = (red.holds(x + d, y) && is_red(red.at(x + d, y))) ||
               (red.holds(x, y + d) && is_red(red.at(x, y + d)));
      outside += liquid && !near;
    }
  EXPECT_GT(blue, reds / 3);
  EXPECT_LT(outside, blue / 100) << "coloured where there is no liquid";
}

TEST_F(ViewWindow, ErrorsOfASceneEndAScreenshot) {
  const fs::path wrong = folder_ / "wrong.toml", png = folder_ / "x.png";
  write_text(wrong, "[domain]\nmx = [1.0, 1.0]\n");
  const ProcessResult r = view({wrong, "--steps", "5", "--screenshot", png});
  EXPECT_EQ(r.code, 2);
  EXPECT_TRUE(
      contains(r.err, "wrong.toml:2:1: error: unknown key domain.mx; did you mean domain.max?"))
      << r.err;
  EXPECT_FALSE(fs::exists(png));
}

TEST_F(ViewWindow, ShowsTheErrorsOfASceneInTheWindow) {
  const fs::path wrong = folder_ / "wrong.toml";
  write_text(wrong, "[domain]\nmx = [1.0, 1.0]\n");
  Process window(freshet_command({"view", wrong.string()}), on_display(3));
  EXPECT_TRUE(window.finish().timed_out) << "it stays open";
}

TEST_F(ViewWindow, NoDisplayIsAClearMessage) {
  const ProcessResult r = run_process(
      {"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", FRESHET_PROGRAM, "view", scene(2)});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "error: there is no display to open a window on")) << r.err;
  EXPECT_EQ(lines_of(r.err).size(), 1u) << r.err;
}

TEST_F(ViewWindow, DisplayWithoutOpenGLIsAClearMessage) {
  const Display plain("-extension GLX");
  const ProcessResult r =
      test::freshet({"view", scene(2)}, {.environment = {"DISPLAY=" + plain.name}, .seconds = 20});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(contains(r.err, "error: there is no OpenGL 3.3 to draw with")) << r.err;
  EXPECT_EQ(lines_of(r.err).size(), 1u) << r.err;
}

TEST_F(ViewWindow, RepeatsALogAndShowsAFinishedRun) {
  const std::string file = scene(2);
  const fs::path log = folder_ / "actions.toml", run_folder = folder_ / "run",
                 png = folder_ / "frame.png";
  write_text(log,
             "scene = \"red2d.toml\"\n[[action]]\nstep = 10\nkey = \"domain.gravity\"\nvalue = "
             "\"[3.0, 0.0]\"\n");
  Simulation sim(load_scene(file));
  for (int k = 0; k < 10; ++k) sim.step();
  sim.change({{"domain.gravity", "[3.0, 0.0]"}});
  for (int k = 0; k < 10; ++k) sim.step();
  const ProcessResult again =
      view({"--replay", log, "--steps", "20", "--pictures", "2", "--report"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(again.out, sim.state_sha256())) << again.out;
  ASSERT_EQ(test::freshet({"run", file, "--output", run_folder.string(), "--set", "time.end=0.01",
                           "--set", "output.frame_every=0.005"})
                .code,
            0);
  const ProcessResult shown =
      view({run_folder, "--steps", "2", "--screenshot", png, "--panels", "--report"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_TRUE(contains(shown.out, "step 20, 0.01 s")) << shown.out;
}

}  // namespace

TEST(ViewWithoutWindow, BuildWithoutGlfwNamesThePackages) {
  if (FRESHET_WINDOW) GTEST_SKIP() << "this build has a window";
  const test::ProcessResult r = test::freshet({"view", "dam_break_2d"});
  EXPECT_EQ(r.code, 1);
  EXPECT_TRUE(test::contains(r.err, "install libglfw3-dev, libimgui-dev and libgl-dev")) << r.err;
}

}  // namespace freshet

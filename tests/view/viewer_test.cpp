// SPDX-License-Identifier: MIT
// What the mouse, the keys and a change of size do in a window, within this process.
#include <gtest/gtest.h>

#if FRESHET_WINDOW
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <functional>
#include <optional>

#include "view/display.h"
#include "window/context.h"
#include "window/redraw.h"
#include "window/viewer.h"

namespace freshet::window {
namespace {

using namespace freshet::test;

class ViewInWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_program("Xvfb"))
      GTEST_SKIP() << "Xvfb is not installed (xvfb, libgl1-mesa-dri): the window is not tested";
    display_.emplace();
    setenv("DISPLAY", display_->name.c_str(), 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    context_.emplace(640, 480, true);
    viewer_.emplace(session_, true);
    viewer_->panels = false;
  }
  void TearDown() override {
    viewer_.reset();
    context_.reset();
  }
  void open(int dimension) {
    const fs::path file = folder_ / "red.toml";
    write_text(file, red_scene(dimension));
    session_.open(file);
    session_.wait();
  }
  /// A picture in which the mouse and the keys are as `input` sets them.
  Image picture(const std::function<void(ImGuiIO&)>& input = {}) {
    context_->poll(0);
    context_->begin_picture();
    ImGuiIO& io = ImGui::GetIO();
    io.WantCaptureMouse = io.WantCaptureKeyboard = false;
    io.MousePos = {float(context_->width()) / 2, float(context_->height()) / 2};
    io.MouseDelta = {0, 0};
    if (input) input(io);
    const auto region = viewer_->region(context_->width(), context_->height());
    viewer_->update(region);
    viewer_->handle_input(region);
    viewer_->draw(region);
    Image image = context_->read(region.left);
    if (viewer_->panels) {
      viewer_->draw_color_bar();
      viewer_->draw_panels();
    }
    context_->draw_panels();
    context_->swap();
    return image;
  }
  static int count_red(const Image& image) {
    int red = 0;
    for (const Color c : image.pixels) red += is_red(c);
    return red;
  }
  /// The place of the red pixels' middle [px].
  static ImVec2 middle_of_red(const Image& image) {
    double x = 0, y = 0;
    for (int j = 0; j < image.height; ++j)
      for (int i = 0; i < image.width; ++i)
        if (is_red(image.at(i, j))) {
          x += i;
          y += j;
        }
    const double n = count_red(image);
    return {float(x / n), float(y / n)};
  }
  static void press(ImGuiIO& io, int key) {
    io.KeysDown[key] = true;
    io.KeysDownDuration[key] = 0;
  }

  TemporaryFolder folder_;
  std::optional<Display> display_;
  view::Session session_;
  std::optional<Context> context_;
  std::optional<Viewer> viewer_;
};

TEST_F(ViewInWindow, IsResizedWhileItRuns) {
  open(3);
  session_.play(true);
  for (const auto& [width, height] : {std::pair(640, 480), {420, 300}, {900, 700}, {70, 64}}) {
    context_->resize(width, height);
    Image image(1, 1, {});
    for (int k = 0; k < 100 && (image.width != width || image.height != height); ++k)
      image = picture();
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_GT(count_red(image), width * height / 100);
  }
  viewer_->panels = true;
  context_->resize(640, 480);
  for (int k = 0; k < 5; ++k) picture();
  EXPECT_LT(viewer_->region(640, 480).width, 640) << "the panels leave the rest";
  session_.play(false);
  EXPECT_GT(session_.wait()->frame.step, 0);
}

TEST_F(ViewInWindow, ClickFindsAParticleAndEscapeLosesIt) {
  open(2);
  const ImVec2 at = middle_of_red(picture());
  picture([&](ImGuiIO& io) {
    io.MousePos = at;
    io.MouseDown[0] = true;
    io.MouseDownDuration[0] = 0;  // pressed within this picture
  });
  picture([&](ImGuiIO& io) {
    io.MousePos = at;
    io.MouseReleased[0] = true;
  });
  ASSERT_TRUE(viewer_->look.marked);
  const Frame& f = viewer_->shown().frame;
  const float x = f.x[2 * *viewer_->look.marked], y = f.x[2 * *viewer_->look.marked + 1];
  EXPECT_NEAR(x, 0.4, 0.06) << "the middle of the block";
  EXPECT_NEAR(y, 0.3, 0.06);
  picture([&](ImGuiIO& io) { press(io, GLFW_KEY_ESCAPE); });
  EXPECT_FALSE(viewer_->look.marked);
}

TEST_F(ViewInWindow, ShiftAndDragPushTheLiquid) {
  open(2);
  const ImVec2 at = middle_of_red(picture());
  const auto drag = [&](float dx, bool first) {
    picture([&](ImGuiIO& io) {
      io.MousePos = {at.x + dx, at.y};
      io.KeyShift = true;
      io.KeyMods = ImGuiKeyModFlags_Shift;
      io.MouseDown[0] = true;
      io.MouseDownDuration[0] = first ? 0.0f : 0.1f;
      io.DeltaTime = 0.02f;
    });
  };
  drag(0, true);
  drag(40, false);
  session_.step(40);
  const auto pushed = session_.wait();
  EXPECT_EQ(pushed->actions, 1u);
  EXPECT_GT(pushed->statistics->momentum[0], 1);
  picture();  // the button is released
  const auto released = session_.wait();
  EXPECT_EQ(released->actions, 2u);
}

TEST_F(ViewInWindow, DragOrbitsAndTheWheelZooms) {
  open(3);
  const Image before = picture();
  const Image turned = picture([&](ImGuiIO& io) {
    io.MouseDown[0] = true;
    io.MouseDelta = {120, 0};
  });
  EXPECT_FALSE(before.pixels == turned.pixels);
  Image near = turned;
  for (int k = 0; k < 4; ++k) near = picture([&](ImGuiIO& io) { io.MouseWheel = 1; });
  EXPECT_GT(count_red(near), 1.3 * count_red(turned));
  EXPECT_TRUE(picture([&](ImGuiIO& io) { press(io, GLFW_KEY_F); }).pixels == before.pixels);
}

TEST_F(ViewInWindow, KeysPlayStepAndRestart) {
  open(2);
  picture();
  picture([&](ImGuiIO& io) { press(io, GLFW_KEY_S); });
  EXPECT_EQ(session_.wait()->frame.step, 1);
  picture([&](ImGuiIO& io) { press(io, GLFW_KEY_SPACE); });
  EXPECT_TRUE(session_.wait()->playing);
  picture();
  picture([&](ImGuiIO& io) { press(io, GLFW_KEY_SPACE); });
  EXPECT_FALSE(session_.wait()->playing);
  picture([&](ImGuiIO& io) { press(io, GLFW_KEY_R); });
  EXPECT_EQ(session_.wait()->frame.step, 0);
}

TEST_F(ViewInWindow, SliceShowsLessAndFieldsHaveOtherColors) {
  open(3);
  const int all = count_red(picture());
  viewer_->look.slice = {2, 0.1, 0.1};
  viewer_->look.floor = false;
  const int cut = count_red(picture());
  EXPECT_LT(cut, all);
  EXPECT_GT(cut, all / 20);
  viewer_->choose_color(ColorBy::pressure);
  EXPECT_LT(count_red(picture()), cut / 4);
}

TEST(ViewRedraw, DrawsForSnapshotsAndEventsAndRarelyAtRest) {
  Redraw redraw;
  int at_start = 0;
  for (int k = 0; k < 20; ++k) at_start += redraw.wanted(false, false, 0.01 * k);
  EXPECT_EQ(at_start, 5) << "panels find their sizes";
  EXPECT_TRUE(redraw.wanted(true, false, 0.21));
  EXPECT_FALSE(redraw.wanted(false, false, 0.22));
  int after_event = redraw.wanted(false, true, 0.23);
  for (int k = 0; k < 20; ++k) after_event += redraw.wanted(false, false, 0.24 + 0.01 * k);
  EXPECT_EQ(after_event, 5);
  EXPECT_TRUE(redraw.wanted(false, false, 1));
}

TEST_F(ViewInWindow, KeyThatIsReleasedBeforeThePictureCounts) {
  open(2);
  picture();
  context_->press(GLFW_KEY_S);
  picture();
  EXPECT_EQ(session_.wait()->frame.step, 1);
  for (int k = 0; k < 3; ++k) picture();
  EXPECT_EQ(session_.wait()->frame.step, 1) << "once";
}

TEST_F(ViewInWindow, TakesAnEventOnce) {
  picture();
  context_->take_event();
  EXPECT_FALSE(context_->take_event());
  context_->wake();
  EXPECT_TRUE(context_->take_event());
  EXPECT_FALSE(context_->take_event());
}

TEST_F(ViewInWindow, TakesDroppedFilesOnceAndShowsTheirErrors) {
  const fs::path good = folder_ / "red.toml", wrong = folder_ / "wrong.toml";
  write_text(good, red_scene(2));
  write_text(wrong, "[domain]\nmx = [1.0, 1.0]\n");
  GLFWwindow* window = glfwGetCurrentContext();
  const auto drop = [&](const fs::path& file) {
    const GLFWdropfun callback = glfwSetDropCallback(window, nullptr);
    glfwSetDropCallback(window, callback);
    const std::string name = file.string();
    const char* names[] = {name.c_str()};
    callback(window, 1, names);
    const auto dropped = context_->take_dropped();
    ASSERT_EQ(dropped.size(), 1u);
    session_.open(dropped[0]);
    session_.wait();
  };
  drop(good);
  EXPECT_GT(count_red(picture()), 1000);
  drop(wrong);
  EXPECT_TRUE(context_->take_dropped().empty());
  EXPECT_GT(count_red(picture()), 1000) << "what was open stays";
  std::string problems;
  for (const Diagnostic& d : viewer_->shown().problems) problems += d.text() + "\n";
  EXPECT_TRUE(contains(
      problems, wrong.string() + ":2:1: error: unknown key domain.mx; did you mean domain.max?"))
      << problems;
}

TEST_F(ViewInWindow, PSavesAPictureAndWritesItsName) {
  open(2);
  picture();
  EXPECT_TRUE(viewer_->take_picture_name().empty());
  picture([&](ImGuiIO& io) { press(io, GLFW_KEY_P); });
  EXPECT_EQ(viewer_->take_picture_name(), "view.png");
  EXPECT_TRUE(viewer_->take_picture_name().empty());
}

TEST_F(ViewInWindow, FilmHasThePicturesOfEqualIntervals) {
  const fs::path file = folder_ / "film.gif";
  if (!has_gif()) GTEST_SKIP() << "giflib is not installed: no film is made";
  Film film;
  film.begin(file, 64, 64, 0.3);
  EXPECT_TRUE(film.wants(0));
  film.add(Image(64, 64, {9, 9, 9}), 0);
  EXPECT_FALSE(film.wants(0.005)) << "0.3 simulated seconds a second are 0.01 s a picture";
  EXPECT_TRUE(film.wants(0.01));
  film.add(Image(32, 64, {9, 9, 9}), 0.01);
  EXPECT_EQ(film.pictures(), 1u) << "of another size";
  film.add(Image(64, 64, {99, 9, 9}), 0.02);
  film.finish();
  EXPECT_FALSE(film.recording());
  EXPECT_GT(fs::file_size(file), 100u);
}

}  // namespace
}  // namespace freshet::window
#endif

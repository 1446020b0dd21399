// SPDX-License-Identifier: MIT
#include "render/balls.h"

#include <gtest/gtest.h>

#include <limits>

#include "cli/files.h"
#include "render/camera.h"
#include "render/draw.h"
#include "render/pictures.h"

namespace freshet::test {
namespace {

/// A camera in front of the balls. A slow ball is blue, a fast one red.
const std::string front =
    "camera = { position = [0, 1, 10], target = [0, 1, 0] }\npicture.color_map = \"article\"\n"
    "picture.color_range = [0, 1]\n";

bool is_blue(Color c) { return c.b > c.r && c.b > c.g; }
bool is_red(Color c) { return c.r > c.g && c.r > c.b; }

TEST(Balls, HideBallsBehindThem) {
  const Scene scene = deep_scene(front);
  Frame frame = balls_at({0, 1, -0.5f, 0, 1, 0.5f});
  frame.v[3] = 1;  // the ball in front is red
  EXPECT_TRUE(is_red(draw(scene, frame).at(100, 100)));
  frame.v = {1, 0, 0, 0, 0, 0};
  EXPECT_TRUE(is_blue(draw(scene, frame).at(100, 100)));
  std::swap(frame.x[2], frame.x[5]);  // the ball that is drawn first is in front
  EXPECT_TRUE(is_red(draw(scene, frame).at(100, 100)));
}

TEST(Balls, OverlapPixelByPixel) {
  const Scene scene = deep_scene(front, {{"particles.spacing", "0.4"}});
  Frame frame = balls_at({-0.05f, 1, 0, 0.05f, 1, 0});  // the balls overlap
  frame.v[3] = 1;
  Image image = draw(scene, frame);
  EXPECT_TRUE(is_blue(image.at(97, 100)));
  EXPECT_TRUE(is_red(image.at(103, 100)));
}

TEST(Balls, Are115PercentOfTheSpacingWide) {
  const auto width_of = [](const std::string& place, float z) {
    const Scene scene = deep_scene("camera = { position = [0, 1, " + place +
                                       "], target = [0, 1, 0], field_of_view = 90 }\n"
                                       "picture.color_map = \"article\"",
                                   {{"particles.spacing", "0.5"}});
    Image with = draw(scene, balls_at({0, 1, z})), without = draw(scene, balls_at({}));
    int width = 0;
    for (int x = 0; x < 200; ++x) width += !(with.at(x, 100) == without.at(x, 100));
    return width;
  };
  EXPECT_NEAR(100 * 0.575 / 4, width_of("4", 0), 1.5);
  EXPECT_NEAR(100 * 0.575 / 4, width_of("5", 1), 1.5);
  EXPECT_NEAR(100 * 0.575 / 8, width_of("8", 0), 1.5);
}

TEST(Balls, BehindTheCameraOrInvalidAreNotDrawn) {
  const Scene scene = deep_scene(front);
  const auto pixels = draw(scene, balls_at({})).pixels;
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(pixels, draw(scene, balls_at({0, 1, 12})).pixels);
  EXPECT_EQ(pixels, draw(scene, balls_at({nan, 1, 0})).pixels);
  EXPECT_EQ(pixels, draw(scene, balls_at({0, inf, 0})).pixels);
  EXPECT_EQ(pixels, draw(scene, balls_at({0, -3e30f, 0})).pixels);
  EXPECT_EQ(pixels, draw(scene, balls_at({0, 1, 10})).pixels);  // at the camera
}

TEST(Balls, CastAShadowOnTheFloor) {
  const Scene scene = deep_scene("camera = { position = [0, 9, 0.1], target = [0, 0, 0] }",
                                 {{"particles.spacing", "0.5"}});
  Image with = draw(scene, balls_at({0.1f, 1.2f, 0.1f})), without = draw(scene, balls_at({}));
  // light comes from the left, the front and above
  const View view(pose_at(scene, 0), 200, 200);
  const auto at = [&](double x, double z) {
    const auto seen = view({x, 0, z});
    return brightness_of(without.at(int(seen.x), int(seen.y))) -
           brightness_of(with.at(int(seen.x), int(seen.y)));
  };
  EXPECT_GT(at(0.1 + 0.45 * 1.2, 0.1 - 0.4 * 1.2), 30);
  EXPECT_EQ(0, at(-0.6, 0.6));
}

TEST(Balls, AreHiddenByWallsInFrontOfThem) {
  const std::string pillar =
      "wall = { shape = \"cylinder\", center = [0, 1, 0.6], radius = 0.2, length = 2 }\n";
  const Scene scene = deep_scene(front + pillar);
  Frame behind = balls_at({0, 1, 0}), before = balls_at({0, 1, 0.9f});
  Image wall = draw(scene, balls_at({}));
  EXPECT_EQ(wall.at(100, 100), draw(scene, behind).at(100, 100));
  EXPECT_TRUE(is_blue(draw(scene, before).at(100, 100)));
  EXPECT_GT(brightness_of(wall.at(100, 100)), 250);
  const Scene tank = deep_scene(
      front + "wall = { shape = \"sphere\", side = \"inside\", center = [0, 1, 0], radius = 1 }\n");
  EXPECT_TRUE(is_blue(draw(tank, behind).at(100, 100)));  // the near side of a tank is not drawn
}

TEST(Balls, DrawWallsOfPoints) {
  const TemporaryFolder folder;
  write_text(folder / "ball.csv", "x,y,z\n0,1,0.5\n");
  const Scene scene = deep_scene(front +
                                 "solver = { name = \"wcsph\", sound_speed = 20 }\n"
                                 "wall = { shape = \"points\", file = \"" +
                                 (folder / "ball.csv").string() + "\" }\n");
  Image image = draw(scene, balls_at({})), nothing = draw(deep_scene(front), balls_at({}));
  EXPECT_FALSE(image.at(100, 100) == nothing.at(100, 100));
  EXPECT_EQ(image.at(150, 100), nothing.at(150, 100));
}

TEST(Balls, HaveTheSamePixelsOnAnyNumberOfThreads) {
  const Scene scene = deep_scene("camera.orbit = 10", {{"picture.height", "130"}});
  std::vector<float> x;
  for (int k = 0; k < 3000; ++k) x.push_back(float(k * 7919 % 1000) / 500 - (k % 3 == 1 ? 0 : 1));
  const auto pixels = draw(scene, balls_at(x), {}, 1).pixels;
  EXPECT_EQ(pixels, draw(scene, balls_at(x), {}, 2).pixels);
  EXPECT_EQ(pixels, draw(scene, balls_at(x), {}, 7).pixels);
}

}  // namespace
}  // namespace freshet::test

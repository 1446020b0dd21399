// SPDX-License-Identifier: MIT
#include "render/dots.h"

#include <gtest/gtest.h>

#include <limits>

#include "render/pictures.h"
#include "render/png.h"

namespace freshet {
namespace {

using test::flat_scene, test::two_dots;

TEST(SpeedColor, GoesFromBlueOverYellowToRed) {
  EXPECT_EQ((Color{0, 0, 255}), speed_color(0));
  EXPECT_EQ((Color{255, 255, 0}), speed_color(0.5f));
  EXPECT_EQ((Color{255, 0, 0}), speed_color(1));
  EXPECT_EQ(speed_color(0), speed_color(-3));
  EXPECT_EQ(speed_color(1), speed_color(7));
}

class OneDot : public ::testing::Test {
 protected:
  Image draw(float px, float py) {
    scene.domain.min = {0, 0};
    scene.domain.max = {4, 3};
    scene.picture.width = 800;
    scene.picture.height = 600;
    scene.picture.stretch = true;
    scene.picture.dots = Dots::glow;
    scene.picture.color_map = ColorMap::article;
    scene.picture.color_scale = ColorScale::picture;
    Frame frame;
    frame.id = {0};
    frame.x = {px, py};
    frame.v = {0, 0};
    return draw_dots(scene, frame);
  }
  Scene scene;
};

TEST_F(OneDot, IsAtItsParticleWithYDownwards) {
  Image image = draw(2, 0.3f);
  EXPECT_EQ((Color{8, 10, 255}), image.at(400, 536));  // 8 + 0, 10 + 0, 28 + 255 saturated
  EXPECT_EQ((Color{8, 10, 28}), image.at(400, 530));
  EXPECT_EQ((Color{80, 80, 120}), image.at(4, 100));
  EXPECT_EQ((Color{80, 80, 120}), image.at(100, 595));
}

TEST_F(OneDot, OutsideOrNanIsNotDrawn) {
  const Image empty = draw(100, 100);
  EXPECT_EQ(empty.pixels, draw(-3e30f, 1).pixels);
  EXPECT_EQ(empty.pixels, draw(std::numeric_limits<float>::quiet_NaN(), 1).pixels);
}

TEST(Dots, ShowTheSelectedWindow) {
  const std::string glow = "picture.dots = \"glow\"\n";
  Image all = draw_dots(flat_scene(glow), two_dots());
  Image part = draw_dots(flat_scene(glow + "picture.window = [1, 0.25, 2, 0.75]"), two_dots());
  const Color ground{8, 10, 28};
  EXPECT_FALSE(all.at(55, 55) == ground);
  EXPECT_EQ(ground, part.at(55, 55));
  EXPECT_EQ(all.at(155, 55), part.at(105, 55));
}

TEST(Dots, AreDiscsOfTheirColor) {
  const std::string white = "picture.background = \"white\"\n";
  Image image = draw_dots(flat_scene(white), two_dots());
  const Color blue{20, 76, 160}, ground{255, 255, 255};
  EXPECT_EQ(blue, image.at(55, 55));
  EXPECT_EQ(blue, image.at(58, 55));  // the spacing is 10 px
  EXPECT_EQ(ground, image.at(62, 55));
  image = draw_dots(flat_scene(white + "picture.dot_radius = 10"), two_dots());
  EXPECT_EQ(blue, image.at(63, 55));
}

/// The width and height of the pixels that are not background, inside the frame.
std::pair<int, int> size_of_drawn(Image image) {
  int left = image.width, top = image.height, right = -1, bottom = -1;
  for (int y = 20; y < image.height - 20; ++y)
    for (int x = 20; x < image.width - 20; ++x) {
      if (image.at(x, y) == Color{8, 10, 28} || image.at(x, y) == Color{80, 80, 120}) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  return {right - left + 1, bottom - top + 1};
}

TEST(Dots, ACircleIsRoundInAnyPicture) {
  for (const char* size : {"", "picture.width = 400\n", "picture.height = 300\n",
                           "picture.width = 400\npicture.height = 300\n",
                           "picture.width = 800\npicture.height = 120\n"}) {
    const Scene scene = parse_scene(
        "domain.max = [4, 1]\nparticles.spacing = 0.1\ntime = { end = 2, step = 1e-3 }\n"
        "fluid = { min = [0, 0], max = [1, 0.5] }\n"
        "wall = { shape = \"sphere\", center = [2, 0.5], radius = 0.3 }\n" +
            std::string(size),
        "test.toml");
    const auto [width, height] = size_of_drawn(draw_dots(scene, Frame{}));
    EXPECT_NEAR(width, height, 1) << size;
    EXPECT_GT(width, 40) << size;
  }
}

TEST(Dots, WallShapesAreDrawn) {
  Image image = draw_dots(
      flat_scene("wall = { shape = \"sphere\", center = [1.5, 0.75], radius = 0.1 }"), Frame{});
  EXPECT_EQ((Color{8, 10, 28}), image.at(155, 50));
  EXPECT_EQ((Color{128, 126, 122}), image.at(155, 30));
  image = draw_dots(flat_scene("wall = { shape = \"sphere\", side = \"inside\", center = [1, 0.5], "
                               "radius = 2 }\nwalls.method = \"reflection\""),
                    Frame{});
  EXPECT_EQ((Color{8, 10, 28}), image.at(105, 55));
}

TEST(Png, DecodesToTheEncodedPixels) {
  Image image(3, 2, {1, 2, 3});
  image.at(2, 1) = {250, 0, 9};
  const Image back = decode_png(encode_png(image));
  EXPECT_EQ(3, back.width);
  EXPECT_EQ(2, back.height);
  EXPECT_EQ(image.pixels, back.pixels);
  EXPECT_THROW(decode_png("no picture"), Error);
}

}  // namespace
}  // namespace freshet

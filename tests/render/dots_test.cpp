// SPDX-License-Identifier: MIT
#include "render/dots.h"

#include <gtest/gtest.h>

#include <limits>

#include "render/png.h"

namespace freshet {
namespace {

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
    Frame frame;
    frame.id = {0};
    frame.x = {px, py};
    frame.v = {0, 0};
    return draw_dots(scene, frame);
  }
  Scene scene;
};

TEST_F(OneDot, LiesWhereItsParticleDoesWithYTurnedOver) {
  Image image = draw(2, 0.3f);
  EXPECT_EQ((Color{8, 10, 255}), image.at(400, 536));  // 8 + 0, 10 + 0, 28 + 255 saturated
  EXPECT_EQ((Color{8, 10, 28}), image.at(400, 530));
  EXPECT_EQ((Color{80, 80, 120}), image.at(4, 100));
  EXPECT_EQ((Color{80, 80, 120}), image.at(100, 595));
}

TEST_F(OneDot, MayLieOutsideOrNowhere) {
  const Image empty = draw(100, 100);
  EXPECT_EQ(empty.pixels, draw(-3e30f, 1).pixels);
  EXPECT_EQ(empty.pixels, draw(std::numeric_limits<float>::quiet_NaN(), 1).pixels);
}

TEST(Png, GivesBackWhatItWasGiven) {
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

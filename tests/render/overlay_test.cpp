// SPDX-License-Identifier: MIT
#include "render/overlay.h"

#include <gtest/gtest.h>

#include "render/dots.h"
#include "render/draw.h"
#include "render/pictures.h"
#include "scene/model/picture_layout.h"

namespace freshet::test {
namespace {

TEST(Overlay, TimeHasAsManyDecimalsAsTheRunNeeds) {
  EXPECT_EQ("t = 0.75 s", time_words(0.75, 2));
  EXPECT_EQ("t = 12.5 s", time_words(12.5, 40));
  EXPECT_EQ("t = 3 s", time_words(3, 200));
  EXPECT_EQ("t = 0.0025 s", time_words(0.0025, 0.05));
}

TEST(Overlay, ScaleBarLengthsAreRound) {
  EXPECT_DOUBLE_EQ(0.5, round_length(0.6));
  EXPECT_DOUBLE_EQ(0.2, round_length(0.4999));
  EXPECT_DOUBLE_EQ(1, round_length(1.9));
  EXPECT_DOUBLE_EQ(0.01, round_length(0.01));
}

/// The bounding box of the pixels in which two images differ.
struct Changed {
  int left = 1000, top = 1000, right = -1, bottom = -1;
  Changed(Image a, Image b) {
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x)
        if (!(a.at(x, y) == b.at(x, y))) {
          left = std::min(left, x);
          right = std::max(right, x);
          top = std::min(top, y);
          bottom = std::max(bottom, y);
        }
  }
};

Changed changed_by(const std::string& key) {
  const std::string size = "picture.width = 600\npicture.height = 300\n";
  std::string base =
      "domain.max = [2, 1]\nparticles.spacing = 0.1\n"
      "time = { end = 2, step = 1e-3 }\nfluid = { min = [0, 0], max = [1, 0.5] }\n" +
      size;
  return {draw(parse_scene(base, "test.toml"), two_dots()),
          draw(parse_scene(base + key, "test.toml"), two_dots())};
}

TEST(Overlay, IsOffByDefault) {
  const Scene scene = flat_scene("");
  EXPECT_EQ(draw_dots(scene, two_dots()).pixels, draw(scene, two_dots()).pixels);
}

TEST(Overlay, TimeIsAtTheTopLeft) {
  const Changed c = changed_by("picture.time_stamp = true");
  EXPECT_GT(c.right, 40);
  EXPECT_LT(c.right, 150);
  EXPECT_LT(c.bottom, 40);
}

TEST(Overlay, ColorBarIsRightOfTheFluid) {
  const Scene scene = flat_scene("picture.color_bar = true");
  const PictureLayout layout = picture_layout(scene);
  const Changed c(draw_dots(scene, two_dots()), draw(scene, two_dots()));
  EXPECT_GE(c.left, layout.width - layout.color_bar);
  EXPECT_GE(c.left, layout.view.left + layout.view.width);
  EXPECT_LT(c.right, layout.width);
  EXPECT_LT(c.top, 20);
  EXPECT_GT(c.bottom, 90);
}

TEST(Overlay, ScaleBarIsOneMetreLong) {
  const std::string base =
      "domain.max = [4, 2]\nparticles.spacing = 0.1\npicture.width = 410\npicture.height = 210\n"
      "time = { end = 2, step = 1e-3 }\nfluid = { min = [0, 0], max = [1, 0.5] }\n"
      "picture.scale_bar = true\n";
  Image image = draw(parse_scene(base, "test.toml"), Frame{});
  int longest = 0;
  for (int y = 0; y < 60; ++y) {
    int run = 0;
    for (int x = 0; x < 200; ++x) {
      run = brightness_of(image.at(x, y)) > 600 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_NEAR(100, longest, 1);  // 1 m; 4 m are 400 px
}

}  // namespace
}  // namespace freshet::test

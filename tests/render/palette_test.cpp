// SPDX-License-Identifier: MIT
#include "render/palette.h"

#include <gtest/gtest.h>

#include <cmath>

namespace freshet {
namespace {

TEST(Palette, KeepsFewColorsExactly) {
  Image image(16, 16, {8, 10, 28});
  for (int k = 0; k < 16; ++k) {
    image.at(k, 3) = {255, 255, 255};
    image.at(k, 5) = {20, 76, 160};
  }
  const PalettedImage reduced = reduce_colors(image);
  ASSERT_EQ(3u, reduced.colors.size());
  for (std::size_t k = 0; k < image.pixels.size(); ++k)
    EXPECT_EQ(image.pixels[k], reduced.colors[reduced.pixels[k]]);
}

TEST(Palette, IsCloseToManyColors) {
  Image image(256, 256, {});
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x)
      image.at(x, y) = {std::uint8_t(x), std::uint8_t(y), std::uint8_t((x + y) / 2)};
  const PalettedImage reduced = reduce_colors(image);
  EXPECT_EQ(256u, reduced.colors.size());
  double squares = 0;
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const Color is = reduced.colors[reduced.pixels[k]], should = image.pixels[k];
    squares += std::pow(is.r - should.r, 2) + std::pow(is.g - should.g, 2);
  }
  EXPECT_LT(std::sqrt(squares / double(image.pixels.size())), 10);
}

TEST(Palette, OfAnEmptyImageIsEmpty) { EXPECT_TRUE(reduce_colors(Image(0, 0, {})).colors.empty()); }

}  // namespace
}  // namespace freshet

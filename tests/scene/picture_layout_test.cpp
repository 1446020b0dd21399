// SPDX-License-Identifier: MIT
#include "scene/model/picture_layout.h"

#include <gtest/gtest.h>

namespace freshet {
namespace {

PictureLayout layout_of(const std::string& domain, const std::string& picture = "") {
  const bool deep = std::count(domain.begin(), domain.end(), ',') == 2;
  return picture_layout(parse_scene(
      "domain.max = " + domain +
          "\nparticles.spacing = 0.1\n"
          "time = { end = 2, step = 1e-3 }\nfluid = { min = " +
          (deep ? "[0, 0, 0], max = [1, 0.5, 0.5]" : "[0, 0], max = [1, 0.5]") + " }\n" + picture,
      "test.toml"));
}

/// The scales of both axes [px/m] for a domain of this size.
std::pair<double, double> scales(const PictureLayout& p, double x, double y) {
  return {(p.view.width - 2 * picture_margin) / x, (p.view.height - 2 * picture_margin) / y};
}

TEST(PictureLayout, SizeFollowsTheDomain) {
  const PictureLayout wide = layout_of("[4, 1]"), tall = layout_of("[1, 4]");
  EXPECT_EQ(800, wide.width);
  EXPECT_EQ(208, wide.height);  // 790 / 4 + 10, and even
  EXPECT_EQ(208, tall.width);
  EXPECT_EQ(800, tall.height);
  EXPECT_EQ(96, layout_of("[400, 1]").height);
}

TEST(PictureLayout, OneSideFollowsTheOther) {
  EXPECT_EQ(110, layout_of("[4, 1]", "picture.width = 410").height);
  EXPECT_EQ(410, layout_of("[4, 1]", "picture.height = 110").width);
  EXPECT_EQ(110, layout_of("[4, 1]", "picture.width = 210\npicture.window = [0, 0, 2, 1]").height);
}

TEST(PictureLayout, BothSidesLeaveTheDomainItsProportions) {
  for (const char* domain : {"[4, 1]", "[1, 4]"}) {
    const PictureLayout p = layout_of(domain, "picture.width = 410\npicture.height = 310");
    const bool wide = domain[1] == '4';
    EXPECT_EQ(410, p.width);
    EXPECT_EQ(310, p.height);
    const auto [x, y] = scales(p, wide ? 4 : 1, wide ? 1 : 4);
    EXPECT_DOUBLE_EQ(x, y) << domain;
    EXPECT_NEAR(205, p.view.left + p.view.width / 2.0, 0.5);
    EXPECT_NEAR(155, p.view.top + p.view.height / 2.0, 0.5);
  }
}

TEST(PictureLayout, StretchesIfAsked) {
  const PictureLayout p =
      layout_of("[4, 1]", "picture = { width = 410, height = 310, stretch = true }");
  EXPECT_EQ(410, p.view.width);
  EXPECT_EQ(310, p.view.height);
}

TEST(PictureLayout, ColorBarHasRoomOfItsOwn) {
  for (const char* domain : {"[4, 1]", "[1, 4]", "[2, 1.2, 0.6]"})
    for (const char* size : {"", "picture.width = 500\n", "picture.height = 500\n",
                             "picture.width = 300\npicture.height = 500\n"}) {
      const PictureLayout p = layout_of(domain, size + std::string("picture.color_bar = true"));
      EXPECT_GE(p.color_bar, 70) << domain << size;
      EXPECT_LE(p.view.left + p.view.width, p.width - p.color_bar) << domain << size;
      EXPECT_GT(p.view.width, 50) << domain << size;
    }
  EXPECT_NEAR(790.0 / 4, scales(layout_of("[4, 1]", "picture.color_bar = true"), 4, 1).first, 1);
}

TEST(PictureLayout, In3DFollowsTheDomainAsTheCameraSeesIt) {
  const PictureLayout cube = layout_of("[1, 1, 1]"), channel = layout_of("[8, 0.5, 0.5]");
  EXPECT_NEAR(1, double(cube.width) / cube.height, 0.15);
  EXPECT_GT(channel.width, channel.height);
  EXPECT_EQ(800, channel.width);
}

}  // namespace
}  // namespace freshet

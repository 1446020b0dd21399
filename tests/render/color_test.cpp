// SPDX-License-Identifier: MIT
#include "render/color.h"

#include <gtest/gtest.h>

#include <limits>

#include "render/pictures.h"

namespace freshet::test {
namespace {

TEST(ColorMaps, HaveTheirEndColorsAtAndBeyondTheEnds) {
  const Color ends[][2] = {{{0, 0, 255}, {255, 0, 0}},
                           {{20, 76, 160}, {240, 250, 255}},
                           {{68, 1, 84}, {253, 231, 37}},
                           {{0, 0, 4}, {252, 255, 164}},
                           {{59, 76, 192}, {180, 4, 38}}};
  for (int k = 0; k < 5; ++k) {
    const auto map = ColorMap(k);
    EXPECT_EQ(ends[k][0], map_color(map, 0)) << k;
    EXPECT_EQ(ends[k][1], map_color(map, 1)) << k;
    EXPECT_EQ(ends[k][0], map_color(map, -5)) << k;
    EXPECT_EQ(ends[k][1], map_color(map, 5)) << k;
    EXPECT_EQ(ends[k][0], map_color(map, std::numeric_limits<float>::quiet_NaN())) << k;
  }
  EXPECT_EQ((Color{221, 221, 221}), map_color(ColorMap::coolwarm, 0.5f));
}

TEST(Coloring, ReadsTheSelectedField) {
  const std::pair<const char*, float> fields[] = {
      {"speed", 5},      {"velocity_x", 3},         {"velocity_y", -4}, {"density", 990},
      {"pressure", 700}, {"density_error", -0.01f}, {"height", 0.25f},  {"id", 1}};
  for (const auto& [word, value] : fields) {
    const Scene scene = flat_scene(std::string("picture.color_by = \"") + word + "\"");
    Frame frame = two_dots();
    frame.v = {0, 0, 3, -4};
    frame.density = {1000, 990};
    frame.pressure = {0, 700};
    frame.x[3] = 0.25f;
    EXPECT_NEAR(value, color_particles(scene, frame).values.at(1), 1e-6) << word;
  }
}

TEST(Coloring, RangeIsOfTheParticlesOrAsSet) {
  Frame frame = two_dots();
  frame.v = {0, 0, 3, -4};
  const auto range = [&](const std::string& tables) {
    const Coloring c = color_particles(flat_scene(tables), frame);
    return std::pair{c.low, c.high};
  };
  EXPECT_EQ(std::pair(0.0f, 5.0f), range(""));
  EXPECT_EQ(std::pair(-4.0f, 4.0f), range("picture.color_by = \"velocity_y\""));
  EXPECT_EQ(std::pair(0.0f, 1.0f), range("picture.color_by = \"id\""));
  EXPECT_EQ(std::pair(1.0f, 2.0f), range("picture.color_range = [1, 2]"));
  frame.v = {0, 0, 0, 0};  // as in the article, the range ends at 0.1 m/s at least
  EXPECT_EQ(std::pair(0.0f, 0.1f), range(""));
}

TEST(Coloring, OfNoParticlesOrNanIsValid) {
  const Scene scene = flat_scene("picture.color_by = \"pressure\"");
  EXPECT_GT(color_particles(scene, Frame{}).high, color_particles(scene, Frame{}).low);
  Frame frame = two_dots();
  frame.pressure = {std::numeric_limits<float>::quiet_NaN(),
                    std::numeric_limits<float>::infinity()};
  const Coloring c = color_particles(scene, frame);
  EXPECT_EQ(map_color(c.map, 0), c(0));
  EXPECT_EQ(map_color(c.map, 1), c(1));
}

}  // namespace
}  // namespace freshet::test

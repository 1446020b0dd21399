// SPDX-License-Identifier: MIT
#include "render/color.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(Coloring, RangeIsOfThePictureParticlesOrAsSet) {
  Frame frame = two_dots();
  frame.v = {0, 0, 3, -4};
  const auto range = [&](const std::string& tables) {
    const Coloring c = color_particles(flat_scene(tables), frame);
    return std::pair{c.low, c.high};
  };
  const std::string own = "picture.color_scale = \"picture\"\n";
  EXPECT_EQ(std::pair(0.0f, 5.0f), range(own));
  EXPECT_EQ(std::pair(-4.0f, 4.0f), range(own + "picture.color_by = \"velocity_y\""));
  EXPECT_EQ(std::pair(0.0f, 1.0f), range(own + "picture.color_by = \"id\""));
  EXPECT_EQ(std::pair(1.0f, 2.0f), range("picture.color_range = [1, 2]"));
  frame.v = {0, 0, 0, 0};  // as in the article, the range ends at 0.1 m/s at least
  EXPECT_EQ(std::pair(0.0f, 0.1f), range(own));
}

/// Particles of speed 1 m/s, but for one of 100 m/s.
Frame one_fast_particle() {
  Frame frame;
  for (std::uint64_t i = 0; i < 200; ++i) {
    frame.id.push_back(i);
    frame.x.insert(frame.x.end(), {0.5f, 0.5f});
    frame.v.insert(frame.v.end(), {i == 77 ? 100.0f : 1.0f, 0});
  }
  frame.density.assign(200, 1000);
  frame.pressure.assign(200, 0);
  return frame;
}

TEST(Coloring, OneFastParticleDoesNotSetTheRange) {
  const Scene scene = flat_scene("");
  const Coloring c = color_particles(scene, one_fast_particle());
  EXPECT_EQ(0, c.low);
  EXPECT_EQ(1, c.high);
  EXPECT_EQ(map_color(ColorMap::water, 1), c(77));
}

TEST(Coloring, RangeIsThatOfTheRunSoFar) {
  const Scene scene = flat_scene("");
  ColorRanges ranges = percentiles_of(scene, one_fast_particle());
  Frame later = one_fast_particle();
  for (float& v : later.v) v /= 2;
  EXPECT_EQ(1, color_particles(scene, later, ranges).high);
  for (float& v : later.v) v *= 6;
  include(ranges, percentiles_of(scene, later));
  EXPECT_EQ(3, color_particles(scene, one_fast_particle(), ranges).high);
}

TEST(Coloring, SlowMotionStaysDark) {
  Frame slow = one_fast_particle();
  for (float& v : slow.v) v *= 1e-6f;
  const double fall = std::sqrt(2 * 9.81 * 1);
  EXPECT_NEAR(0.1 * fall, color_particles(flat_scene(""), slow).high, 1e-6);
}

TEST(Coloring, PercentilesOfManyParticlesAreThoseOfASample) {
  Frame many;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    many.id.push_back(i);
    many.x.insert(many.x.end(), {0, float(i % 256) / 256});  // ids are regular, as in a lattice
    many.v.insert(many.v.end(), {0, 0});
  }
  many.density = many.pressure = std::vector<float>(100000, 0.0f);
  const ColorRange height = percentiles_of(flat_scene(""), many)[std::size_t(ColorBy::height)];
  EXPECT_NEAR(0.01, height.low, 0.01);
  EXPECT_NEAR(0.99, height.high, 0.01);
}

TEST(Coloring, DefaultMapSuitsTheQuantity) {
  const auto map = [](const char* quantity) {
    return color_particles(flat_scene(std::string("picture.color_by = \"") + quantity + "\""),
                           two_dots())
        .map;
  };
  EXPECT_EQ(ColorMap::water, map("speed"));
  EXPECT_EQ(ColorMap::coolwarm, map("velocity_x"));
  EXPECT_EQ(ColorMap::coolwarm, map("density_error"));
  EXPECT_EQ(ColorMap::viridis, map("pressure"));
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

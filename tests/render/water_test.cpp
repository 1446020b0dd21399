// SPDX-License-Identifier: MIT
#include "render/water.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "render/camera.h"
#include "render/draw.h"
#include "render/fixed_triangle.h"
#include "render/pictures.h"
#include "render/stage.h"
#include "render/water_light.h"

namespace freshet::test {
namespace {

const std::string style = "picture.style = \"water\"\npicture.background = \"white\"\n";
const std::string above = "camera = { position = [0, 9, 0.1], target = [0, 0, 0] }\n";

/// A lattice of particles in a box, on the floor.
std::vector<float> block(double x0, double x1, double height, double z0, double z1) {
  std::vector<float> x;
  for (double i = x0 + 0.05; i < x1; i += 0.1)
    for (double j = 0.05; j < height; j += 0.1)
      for (double k = z0 + 0.05; k < z1; k += 0.1)
        x.insert(x.end(), {float(i), float(j), float(k)});
  return x;
}

Scene water_scene(const std::string& tables) {
  return deep_scene(style + tables, {{"particles.spacing", "0.1"}});
}

/// 0 for grey, 1 for blue without red, -1 for red without blue.
double blueness(Color c) { return (int(c.b) - int(c.r)) / std::max(1.0, double(c.b) + c.r); }

TEST(Water, IsBluerWhereItIsDeeper) {
  const Scene scene = water_scene(above);
  std::vector<float> x = block(-1, 0, 0.2, -1, 1), deep = block(0, 1, 0.8, -1, 1);
  x.insert(x.end(), deep.begin(), deep.end());
  const Image image = draw(scene, balls_at(x));
  const View view(pose_at(scene, 0), 200, 200);
  const auto at = [&](double px, double py, double pz) {
    const auto seen = view({px, py, pz});
    return blueness(image.at(int(seen.x), int(seen.y)));
  };
  const double dry = blueness(draw(scene, balls_at({})).at(60, 100));
  EXPECT_GT(at(-0.5, 0.2, 0), dry + 0.1);
  EXPECT_GT(at(0.5, 0.8, 0), at(-0.5, 0.2, 0) + 0.05);
}

TEST(Water, HasTheSamePixelsOnAnyNumberOfThreads) {
  const Scene scene = water_scene("camera.orbit = 10\npicture.time_stamp = true\n");
  std::vector<float> x = block(-1, 0.3, 0.8, -1, 1);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-0.04f, 0.04f);
  for (float& v : x) v += noise(random);
  x.insert(x.end(), {0.7f, 1.2f, 0.1f, 0.8f, 0.9f, -0.4f});  // droplets
  const auto pixels = draw(scene, balls_at(x), {}, 1).pixels;
  EXPECT_EQ(pixels, draw(scene, balls_at(x), {}, 2).pixels);
  EXPECT_EQ(pixels, draw(scene, balls_at(x), {}, 4).pixels);
}

TEST(Water, WithoutFluidIsTheEmptyStage) {
  const Scene scene = deep_scene(
      style + "wall = { shape = \"cylinder\", center = [0, 1, 0.6], radius = 0.2, length = 2 }\n");
  const Color white{255, 255, 255};
  const int side = 200 * oversampling;
  const View view(pose_at(scene, 0), side, side);
  Band band(side, 0, side, white);
  Stage(scene, balls_at({}), view, white, {.fluid_opacity = 1, .tiles = true}).draw(band);
  Image stage(200, 200, white);
  resolve(band, stage);
  EXPECT_EQ(stage.pixels, draw(scene, balls_at({})).pixels);
  EXPECT_FALSE(stage.at(100, 80) == white);  // the pillar
}

TEST(Water, OfInvalidOrFarParticlesIsNotDrawn) {
  const Scene scene = water_scene("");
  const auto empty = draw(scene, balls_at({})).pixels;
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              inf = std::numeric_limits<float>::infinity();
  EXPECT_EQ(empty, draw(scene, balls_at({nan, 1, 0})).pixels);
  EXPECT_EQ(empty, draw(scene, balls_at({0, inf, 0})).pixels);
  EXPECT_EQ(empty, draw(scene, balls_at({0, -3e30f, 0})).pixels);
}

TEST(Water, IsHiddenByWallsInFrontOfIt) {
  const std::string front = "camera = { position = [0, 1, 10], target = [0, 1, 0] }\n",
                    pillar =
                        "wall = { shape = \"cylinder\", center = [0, 1, 0.6], radius = 0.3, "
                        "length = 2, axis = [0, 1, 0] }\n";
  const Scene scene = water_scene(front + pillar);
  const Color wall = draw(scene, balls_at({})).at(100, 100);
  EXPECT_EQ(wall, draw(scene, balls_at(block(-0.5, 0.5, 1.5, -0.9, 0))).at(100, 100));
  const Image before = draw(scene, balls_at(block(-0.5, 0.5, 1.5, 0.91, 1.4)));
  EXPECT_FALSE(wall == before.at(100, 100));
  EXPECT_GT(blueness(before.at(100, 100)), blueness(wall) + 0.05);
}

TEST(Water, HasTheColorOfEachLiquid) {
  const Scene scene =
      deep_scene(style + above,
                 {{"particles.spacing", "0.1"},
                  {"fluid",
                   "[{ min = [-1, 0, -1], max = [0, 1, 1], color = \"#2060e0\" }, { min = [0, 0, "
                   "-1], max = [1, 1, 1], color = \"#e06020\" }]"}});
  std::vector<float> x = block(-1, 0, 1, -1, 1), right = block(0, 1, 1, -1, 1);
  const std::size_t first = x.size() / 3;
  x.insert(x.end(), right.begin(), right.end());
  Frame frame = balls_at(x);
  frame.liquid.assign(frame.size(), 1);
  std::fill_n(frame.liquid.begin(), first, 0);
  const Image image = draw(scene, frame);
  EXPECT_GT(blueness(image.at(75, 100)), 0.1);
  EXPECT_LT(blueness(image.at(125, 100)), -0.1);
}

/// Drawn with the eye in the liquid, whose near faces are behind the eye.
TEST(Water, SurroundsTheEye) {
  const Scene scene = water_scene("camera = { position = [0, 0.5, 0.8], target = [0, 0.5, 0] }\n");
  const Image image = draw(scene, balls_at(block(-1, 1, 1.2, -1, 1)));
  EXPECT_GT(blueness(image.at(100, 100)), 0.1);
}

TEST(FixedTriangle, CoversEachSampleOfACutSquareOnce) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(0, 24);  // many corners and edges meet sample centres
  const auto point = [](int x, int y) { return FixedPoint{128 * x, 128 * y}; };
  for (int round = 0; round < 200; ++round) {
    const FixedPoint corners[4] = {point(0, 0), point(24, 0), point(24, 24), point(0, 24)},
                     inner = point(place(random), place(random));
    int covered[12][12] = {};
    for (std::size_t k = 0; k < 4; ++k) {
      const FixedTriangle triangle({corners[k], corners[(k + 1) % 4], inner});
      triangle.each_sample(12, 0, 12, [&](int x, int y, Vec<3, double> shares) {
        ++covered[y][x];
        EXPECT_NEAR(1, shares.x + shares.y + shares.z, 1e-12);
      });
    }
    for (const auto& row : covered)
      for (const int times : row) ASSERT_EQ(1, times) << inner.x << " " << inner.y;
  }
}

TEST(WaterLight, LosesLightByBeersLaw) {
  const Absorption blue({64, 156, 220}, 2.0);
  const auto one = blue(0.1f).through, two = blue(0.2f).through;
  EXPECT_NEAR(one.x * one.x, two.x, 1e-6f);
  EXPECT_NEAR(one.z * one.z, two.z, 1e-6f);
  EXPECT_LT(one.x, one.y);
  EXPECT_LT(one.y, one.z);
  EXPECT_EQ(1, blue(0).through.x);
  EXPECT_NEAR(light_of({64, 156, 220}).y, blue(0.5f).through.y, 1e-5f);  // a quarter of 2 m
}

TEST(WaterLight, ReflectsAndRefractsByTheLaws) {
  EXPECT_NEAR(0.02, fresnel(1), 1e-6);
  EXPECT_NEAR(1, fresnel(0), 1e-6);
  const Vec<3, float> ray{0.6f, -0.8f, 0}, up{0, 1, 0}, bent = refracted(ray, up);
  EXPECT_NEAR(1, norm(bent), 1e-5);
  EXPECT_NEAR(0.6 / 1.33, bent.x, 1e-5);  // Snell
  EXPECT_LT(bent.y, 0);
  const auto brightness_at = [](float height) {
    return sky_light({std::sqrt(1 - height * height), height, 0}).y;
  };
  EXPECT_GT(brightness_at(1), brightness_at(0.5f));
  EXPECT_GT(brightness_at(0.5f), brightness_at(0));
}

TEST(WaterLight, KeepsColors) {
  for (int v = 0; v < 256; ++v) {
    const Color c{std::uint8_t(v), std::uint8_t(255 - v), 7};
    EXPECT_EQ(c, color_of(light_of(c)));
  }
}

}  // namespace
}  // namespace freshet::test

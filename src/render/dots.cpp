// SPDX-License-Identifier: MIT
#include "render/dots.h"

#include <algorithm>
#include <cmath>

#include "render/balls.h"

namespace freshet {
namespace {

constexpr Color background{8, 10, 28}, frame{80, 80, 120};
constexpr int margin = 5;                   // px between the picture's edge and the domain's
constexpr float dimmest_full_speed = 0.1f;  // m/s that at least stand for red
constexpr float softness = 0.7f;            // of the dot's radius: where its weight is 1/e

std::uint8_t add(std::uint8_t below, std::uint8_t color, float weight) {
  return std::uint8_t(std::min(255.0f, float(below) + float(color) * weight));
}

/// A dot's weights exp(-d^2/(0.7 r)^2), 0 outside its radius.
std::vector<float> dot_weights(int radius) {
  std::vector<float> weights;
  const float sigma2 = float(radius) * softness * float(radius) * softness;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const int d2 = dx * dx + dy * dy;
      weights.push_back(d2 > radius * radius ? 0 : std::exp(-float(d2) / sigma2));
    }
  return weights;
}

void add_dot(Image& image, int px, int py, Color color, int radius,
             const std::vector<float>& weights) {
  auto weight = weights.begin();
  for (int y = py - radius; y <= py + radius; ++y)
    for (int x = px - radius; x <= px + radius; ++x, ++weight)
      if (*weight > 0 && image.holds(x, y)) {
        Color& c = image.at(x, y);
        c = {add(c.r, color.r, *weight), add(c.g, color.g, *weight), add(c.b, color.b, *weight)};
      }
}

void draw_frame(Image& image) {
  const int right = image.width - margin, bottom = image.height - margin;
  for (int x = 0; x < image.width; ++x) image.at(x, margin - 1) = image.at(x, bottom) = frame;
  for (int y = 0; y < image.height; ++y) image.at(margin - 1, y) = image.at(right, y) = frame;
}

/// Pixels from the left (or the bottom) edge of the picture; a particle far out is far out here
/// too.
int to_pixels(float x, double low, double high, int size) {
  const float p = (x - float(low)) / float(high - low) * float(size - 2 * margin);
  return int(std::clamp(p, -1e6f, 1e6f));
}

}  // namespace

Color speed_color(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  const float r = std::min(1.0f, t * 2), g = t < 0.5f ? t * 2 : 2 - t * 2;
  const float b = std::max(0.0f, 1 - t * 2);
  return {std::uint8_t(r * 255), std::uint8_t(g * 255), std::uint8_t(b * 255)};
}

Image draw_dots(const Scene& scene, const Frame& fluid) {
  Image image(int(scene.picture.width), int(scene.picture.height), background);
  const int radius = int(scene.picture.dot_radius);
  const std::vector<float> weights = dot_weights(radius);
  std::vector<float> speeds;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const float u = float(fluid.v[2 * i]), w = float(fluid.v[2 * i + 1]);
    speeds.push_back(std::sqrt(u * u + w * w));
  }
  float fastest = dimmest_full_speed;
  for (const float speed : speeds) fastest = std::max(fastest, speed);
  const auto &min = scene.domain.min, &max = scene.domain.max;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const float x = float(fluid.x[2 * i]), y = float(fluid.x[2 * i + 1]);
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const int px = to_pixels(x, min[0], max[0], image.width) + margin;
    const int py = image.height - margin - to_pixels(y, min[1], max[1], image.height);
    add_dot(image, px, py, speed_color(speeds[i] / fastest), radius, weights);
  }
  draw_frame(image);
  return image;
}

Image draw(const Scene& scene, const Frame& fluid) {
  return fluid.dimension == 2 ? draw_dots(scene, fluid) : draw_balls(scene, fluid);
}

PictureStatistics picture_statistics(const Image& image) {
  PictureStatistics s;
  s.pixels = std::int64_t(image.pixels.size());
  const std::size_t bottom = std::size_t(image.height * 2 / 3) * std::size_t(image.width);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const Color c = image.pixels[k];
    s.bright += c.r > 50 || c.g > 30;
    s.bottom_third += k >= bottom && c != background;
  }
  return s;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "render/water_light.h"

#include <algorithm>
#include <cmath>

#include "render/floor.h"

namespace freshet {
namespace {

constexpr float refractive_index = 1.33f;
constexpr float least_reflection = 0.02f;  // of water, seen along the normal
constexpr Light horizon{0.12f, 0.14f, 0.17f}, zenith{0.85f, 1.1f, 1.45f};
constexpr Light below{0.015f, 0.03f, 0.05f};  // what faces that look down reflect
constexpr Light sun{9.0f, 8.6f, 7.8f};
constexpr float glow = 0.35f;
constexpr double colored_length = 0.25;  // of the scene's length: gives white light the colour
constexpr double cloudiness = 1.8;       // scattering over the scene's length
constexpr float cloud_brightness = 0.3f;

float to_linear(std::uint8_t v) {
  const float s = float(v) / 255;
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t to_srgb(float v) {
  v = std::clamp(v, 0.0f, 1.0f);
  const float s = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
  return std::uint8_t(255 * s + 0.5f);
}

}  // namespace

Light light_of(Color c) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (std::size_t k = 0; k < 256; ++k) t[k] = to_linear(std::uint8_t(k));
    return t;
  }();
  return {table[c.r], table[c.g], table[c.b]};
}

Color color_of(Light l) { return {to_srgb(l.x), to_srgb(l.y), to_srgb(l.z)}; }

Light sky_light(Vec<3, float> d) {
  const Point l = light_direction();
  const float to_sun = std::max(0.0f, dot(d, Vec<3, float>{float(l.x), float(l.y), float(l.z)}));
  const float up = std::max(0.0f, d.y), down = std::min(1.0f, std::max(0.0f, -4 * d.y));
  Light light = horizon + up * (1.4f - 0.4f * up) * (zenith - horizon);
  light = light + down * (below - light);
  return light + glow * std::pow(to_sun, 24.0f) * Light{1, 0.97f, 0.9f} +
         std::pow(to_sun, 250.0f) * sun;
}

float fresnel(float facing) {
  const float rest = std::clamp(1 - facing, 0.0f, 1.0f), square = rest * rest;
  return least_reflection + (1 - least_reflection) * square * square * rest;
}

Vec<3, float> refracted(Vec<3, float> ray, Vec<3, float> normal) {
  const float facing = -dot(ray, normal), part = 1 / refractive_index;
  if (facing <= 0) return ray;
  const float inside = std::sqrt(1 - part * part * (1 - facing * facing));
  return part * ray + (part * facing - inside) * normal;
}

Absorption::Absorption(Color liquid, double scale) : cloud_(float(cloudiness / scale)) {
  const Light c = light_of(liquid);
  const auto rate = [&](float part) {
    return float(-std::log(std::clamp(double(part), 0.01, 0.98)) / (colored_length * scale));
  };
  rate_ = {rate(c.x), rate(c.y), rate(c.z)};
  color_ = cloud_brightness * c;
}

Absorption::Passed Absorption::operator()(float length) const {
  const Light through{std::exp(-rate_.x * length), std::exp(-rate_.y * length),
                      std::exp(-rate_.z * length)};
  return {through, (1 - std::exp(-cloud_ * length)) * color_};
}

}  // namespace freshet

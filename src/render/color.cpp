// SPDX-License-Identifier: MIT
#include "render/color.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "render/dots.h"
#include "scene/model/background.h"

namespace freshet {
namespace {

constexpr float dimmest_full_speed = 0.1f;  // minimum speed at the red end of the map [m/s]

// Colours at equal distances. Sources: water is our own; viridis and inferno are by Smith and van
// der Walt (CC0); coolwarm is from the table of Moreland, "Diverging Color Maps for Scientific
// Visualization" (2009).
constexpr Color water[] = {
    {20, 76, 160}, {28, 112, 196}, {64, 156, 220}, {136, 206, 238}, {240, 250, 255}};
constexpr Color viridis[] = {{68, 1, 84},    {72, 40, 120},  {62, 73, 137},  {49, 104, 142},
                             {38, 130, 142}, {31, 158, 137}, {53, 183, 121}, {110, 206, 88},
                             {181, 222, 43}, {253, 231, 37}};
constexpr Color inferno[] = {{0, 0, 4},      {27, 12, 65},   {74, 12, 107},  {120, 28, 109},
                             {165, 44, 96},  {207, 68, 70},  {237, 105, 37}, {251, 155, 6},
                             {247, 209, 61}, {252, 255, 164}};
constexpr Color coolwarm[] = {{59, 76, 192},   {98, 130, 234},  {141, 176, 254},
                              {184, 208, 249}, {221, 221, 221}, {245, 196, 173},
                              {244, 154, 123}, {222, 96, 77},   {180, 4, 38}};

constexpr Color liquid_colors[] = {{64, 156, 220},  {237, 165, 37},  {92, 184, 92},
                                   {214, 86, 82},   {150, 110, 200}, {60, 190, 180},
                                   {235, 130, 180}, {170, 170, 170}};

Color liquid_color(const std::string& given, std::size_t k) {
  if (const auto c = background_color(given)) return {(*c)[0], (*c)[1], (*c)[2]};
  return liquid_colors[k % std::size(liquid_colors)];
}

Color between(std::span<const Color> colors, float t) {
  const float at = t * float(colors.size() - 1);
  const std::size_t k = std::min(std::size_t(at), colors.size() - 2);
  const float f = at - float(k);
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t(float(a) + f * (float(b) - float(a)) + 0.5f);
  };
  const Color a = colors[k], b = colors[k + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

float speed_of(const Frame& f, std::size_t i) {
  float sum = 0;
  for (std::size_t d = 0; d < std::size_t(f.dimension); ++d) {
    const float u = f.v[std::size_t(f.dimension) * i + d];
    sum += u * u;
  }
  return std::sqrt(sum);
}

/// The liquid of particle i; 0 for an index beyond `count`, because a file may hold any number.
std::size_t liquid_of(const Frame& f, std::size_t i, std::size_t count) {
  const std::size_t k = f.liquid.empty() ? 0 : std::size_t(f.liquid[i]);
  return k < count ? k : 0;
}

float value_of(const Scene& s, const std::vector<float>& rest_density, const Frame& f,
               std::size_t i) {
  const auto d = std::size_t(f.dimension);
  switch (s.picture.color_by) {
    case ColorBy::speed:
      return speed_of(f, i);
    case ColorBy::velocity_x:
      return f.v[d * i];
    case ColorBy::velocity_y:
      return f.v[d * i + 1];
    case ColorBy::velocity_z:
      return f.v[d * i + d - 1];
    case ColorBy::density:
      return f.density[i];
    case ColorBy::density_error:
      return f.density[i] / rest_density[liquid_of(f, i, rest_density.size())] - 1;
    case ColorBy::pressure:
      return f.pressure[i];
    case ColorBy::height:
      return f.x[d * i + 1];
    case ColorBy::id:
      return float(f.id[i]);
    case ColorBy::liquid:
      return float(liquid_of(f, i, rest_density.size()));
  }
  return 0;
}

std::string label_of(const Scene& s) {
  const bool flat = s.dimension() == 2;
  switch (s.picture.color_by) {
    case ColorBy::speed:
      return "speed [m/s]";
    case ColorBy::velocity_x:
      return "velocity x [m/s]";
    case ColorBy::velocity_y:
      return "velocity y [m/s]";
    case ColorBy::velocity_z:
      return "velocity z [m/s]";
    case ColorBy::density:
      return flat ? "density [kg/m²]" : "density [kg/m³]";
    case ColorBy::density_error:
      return "density error";
    case ColorBy::pressure:
      return flat ? "pressure [N/m]" : "pressure [Pa]";
    case ColorBy::height:
      return "height [m]";
    case ColorBy::id:
      return "id";
    case ColorBy::liquid:
      return "liquid";
  }
  return "";
}

/// Sets the range to that of the values; for signed quantities it is symmetric about zero.
void fit_range(ColorBy what, Coloring& c) {
  float low = std::numeric_limits<float>::max(), high = -low;
  for (const float v : c.values)
    if (std::isfinite(v)) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  const bool sign = what == ColorBy::velocity_x || what == ColorBy::velocity_y ||
                    what == ColorBy::velocity_z || what == ColorBy::density_error;
  if (what == ColorBy::speed) {
    low = 0;
    high = std::max(dimmest_full_speed, high);
  } else if (sign) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  if (low > high) low = high = 0;  // no values
  c.low = low;
  c.high = high > low ? high : low + std::max(1.0f, std::abs(low));
}

}  // namespace

Color map_color(ColorMap map, float t) {
  t = t > 0 ? std::min(t, 1.0f) : 0;  // NaN becomes 0
  switch (map) {
    case ColorMap::article:
      return speed_color(t);
    case ColorMap::water:
      return between(water, t);
    case ColorMap::viridis:
      return between(viridis, t);
    case ColorMap::inferno:
      return between(inferno, t);
    case ColorMap::coolwarm:
      return between(coolwarm, t);
  }
  return {};
}

Color Coloring::at(float t) const {
  if (liquids.empty()) return map_color(map, t);
  const float k = t > 0 ? t * float(liquids.size()) : 0;  // NaN becomes 0
  return liquids[std::min(std::size_t(k), liquids.size() - 1)];
}

Color ground_color(const Scene& scene) {
  const auto c = background_color(scene.picture.background).value_or(*background_color("night"));
  return {c[0], c[1], c[2]};
}

bool is_light(Color c) { return int(c.r) + c.g + c.b > 3 * 127; }

Coloring color_particles(const Scene& s, const Frame& frame) {
  const ColorMap map =
      s.picture.color_map.value_or(frame.dimension == 2 ? ColorMap::article : ColorMap::water);
  Coloring c{map, 0, 1, {}, label_of(s), {}};
  const auto liquids = s.liquids();
  std::vector<float> rest_density;
  for (const Scene::Liquid& liquid : liquids) rest_density.push_back(float(liquid.rest_density));
  c.values.reserve(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i)
    c.values.push_back(value_of(s, rest_density, frame, i));
  if (s.picture.color_by == ColorBy::liquid) {
    for (std::size_t k = 0; k < liquids.size(); ++k)
      c.liquids.push_back(liquid_color(liquids[k].color, k));
    c.low = -0.5f;
    c.high = float(liquids.size()) - 0.5f;
    return c;
  }
  if (s.picture.color_range.size() == 2) {
    c.low = float(s.picture.color_range[0]);
    c.high = float(s.picture.color_range[1]);
  } else {
    fit_range(s.picture.color_by, c);
  }
  return c;
}

}  // namespace freshet

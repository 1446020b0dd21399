// SPDX-License-Identifier: MIT
#include "render/color.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/axis.h"
#include "render/dots.h"
#include "scene/model/background.h"

namespace freshet {
namespace {

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

constexpr Color default_liquids[] = {{64, 156, 220},  {237, 165, 37},  {92, 184, 92},
                                     {214, 86, 82},   {150, 110, 200}, {60, 190, 180},
                                     {235, 130, 180}, {170, 170, 170}};

Color liquid_color(const std::string& given, std::size_t k) {
  if (const auto c = background_color(given)) return {(*c)[0], (*c)[1], (*c)[2]};
  return default_liquids[k % std::size(default_liquids)];
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

ColorMap default_map(ColorBy quantity) {
  switch (quantity) {
    case ColorBy::velocity_x:
    case ColorBy::velocity_y:
    case ColorBy::velocity_z:
    case ColorBy::density_error:
      return ColorMap::coolwarm;
    case ColorBy::speed:
    case ColorBy::liquid:
      return ColorMap::water;
    default:
      return ColorMap::viridis;
  }
}

ColorRange limits_of(const Scene& s, const Coloring& c, const Frame& frame,
                     const ColorRanges& ranges) {
  const auto& p = s.picture;
  if (p.color_range.size() == 2) return {float(p.color_range[0]), float(p.color_range[1])};
  if (p.color_scale == ColorScale::picture) return picture_limits(p.color_by, c.values);
  const auto quantity = std::size_t(p.color_by);
  const ColorRange& range = ranges[quantity];
  return color_limits(s, range.is_empty() ? percentiles_of(s, frame)[quantity] : range);
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

std::vector<Color> liquid_colors(const Scene& scene) {
  const auto liquids = scene.liquids();
  std::vector<Color> colors;
  for (std::size_t k = 0; k < liquids.size(); ++k)
    colors.push_back(liquid_color(liquids[k].color, k));
  return colors;
}

Coloring color_particles(const Scene& s, const Frame& frame, const ColorRanges& ranges) {
  const ColorBy quantity = s.picture.color_by;
  Coloring c{s.picture.color_map.value_or(default_map(quantity)),
             0,
             1,
             {},
             axis_title(quantity_name(quantity), quantity_unit(quantity, s.dimension())),
             {}};
  const std::vector<float> rest_density = rest_densities(s);
  c.values.reserve(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i)
    c.values.push_back(quantity_value(quantity, rest_density, frame, i));
  if (quantity == ColorBy::liquid) {
    c.liquids = liquid_colors(s);
    c.low = -0.5f;
    c.high = float(c.liquids.size()) - 0.5f;
    return c;
  }
  const ColorRange limits = limits_of(s, c, frame, ranges);
  c.low = limits.low;
  c.high = limits.high;
  return c;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/color_range.h"
#include "render/image.h"

namespace freshet {

/// The colour of a map at t, clamped to 0 ... 1; the first colour for NaN.
Color map_color(ColorMap map, float t);

/// The colour of picture.background; the article's background if it is not a colour.
Color ground_color(const Scene& scene);
bool is_light(Color ground);

/// The colour of the k-th liquid: Scene::Liquid::color, or one of a palette if that is empty.
Color liquid_color(const std::string& given, std::size_t k);

/// The colouring of the particles of a frame.
struct Coloring {
  ColorMap map;
  float low, high;             ///< the values at the ends of the map
  std::vector<float> values;   ///< one per particle
  std::string label;           ///< "speed [m/s]"
  std::vector<Color> liquids;  ///< replaces the map if not empty: indexed by the value

  Color operator()(std::size_t i) const { return at((values[i] - low) / (high - low)); }
  /// The colour at t, 0 at `low` and 1 at `high`.
  Color at(float t) const;
};

/// The colouring by the scene's picture.color_by, color_map, color_range and color_scale. `ranges`
/// are those of the run up to this frame. An empty range is replaced by that of the frame.
Coloring color_particles(const Scene& scene, const Frame& frame, const ColorRanges& ranges = {});

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/image.h"

namespace freshet {

/// The colour of a map at t = 0 ... 1; beyond, the ends, and the first one for NaN.
Color map_color(ColorMap map, float t);

/// picture.background, or the article's ground where that is none.
Color ground_color(const Scene& scene);
bool is_light(Color ground);

/// What the particles of a frame are coloured by.
struct Coloring {
  ColorMap map;
  float low, high;             ///< the values at the ends of the map
  std::vector<float> values;   ///< one a particle
  std::string label;           ///< "speed [m/s]"
  std::vector<Color> liquids;  ///< by the value, a whole number, instead of the map; else empty

  Color operator()(std::size_t i) const { return at((values[i] - low) / (high - low)); }
  /// At t = 0 ... 1 between low and high.
  Color at(float t) const;
};

/// As the scene's picture.color_by, color_map and color_range say.
Coloring color_particles(const Scene& scene, const Frame& frame);

}  // namespace freshet

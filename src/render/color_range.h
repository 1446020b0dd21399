// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <limits>
#include <string>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

struct ColorRange {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  bool is_empty() const { return !(low <= high); }
  void include(const ColorRange& other);
};

/// Ranges of the quantities that colours can show, in the order of ColorBy without `liquid`.
using ColorRanges = std::array<ColorRange, std::size_t(ColorBy::liquid)>;

/// "velocity x"
std::string quantity_name(ColorBy quantity);
/// The unit in ASCII, as in the tables of a run: "kg/m^3". Empty for numbers without a unit.
std::string quantity_unit(ColorBy quantity, int dimension);

/// The value of particle i. Rest densities are those of the scene's liquids.
float quantity_value(ColorBy quantity, const std::vector<float>& rest_density, const Frame& frame,
                     std::size_t i);
std::vector<float> rest_densities(const Scene& scene);

/// The first and the 99th percentile of each quantity, of at most 2048 particles that their ids
/// choose. Skips values that are not finite.
ColorRanges percentiles_of(const Scene& scene, const Frame& frame);
void include(ColorRanges& all, const ColorRanges& more);

/// The values at the ends of the colours for values in this range: speeds start from 0, and signed
/// quantities have 0 in the middle. Slow motion stays dark: speeds end at a tenth or more of those
/// that a fall through the domain reaches.
ColorRange color_limits(const Scene& scene, const ColorRange& values);
/// The limits for one picture, as in the article: from the minimum to the maximum, and speeds from
/// 0 to at least 0.1 m/s.
ColorRange picture_limits(ColorBy quantity, const std::vector<float>& values);

}  // namespace freshet

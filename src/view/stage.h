// SPDX-License-Identifier: MIT
/// What a painter draws, as numbers: a window takes them from a thread, a web page from a worker.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "render/color.h"
#include "view/shapes.h"

namespace freshet::view {

/// The surroundings of a scene's fluid.
struct Stage {
  bool flat = true;
  float spacing = 1;
  float glow = 0;  ///< radius of glowing dots [m]; 0: particles are discs
  Point low{}, high{};
  Tint background{};
  Camera::Start start;
  std::vector<Part> parts;
};

/// The stage of a scene that has its defaults. A file of points that cannot be read draws nothing.
Stage stage_of(const Scene& scene);
/// The stage as one array, and back.
std::vector<float> packed(const Stage& stage);
Stage unpacked(std::span<const float> numbers);

inline constexpr int map_size = 256;

/// A frame.
struct Shown {
  std::vector<float> balls;       ///< position and place in the colour map: four numbers each
  std::vector<std::uint8_t> map;  ///< RGBA, map_size colours
  std::vector<float> foam;        ///< positions: three numbers each
  std::vector<float> placements;  ///< a matrix for each part
};

Shown shown_of(const Frame& frame, const Coloring& coloring, const Stage& stage);

}  // namespace freshet::view

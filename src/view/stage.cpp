// SPDX-License-Identifier: MIT
#include "view/stage.h"

#include <algorithm>

#include "scene/model/picture_layout.h"

namespace freshet::view {
namespace {

constexpr double dot_radius = 5;  // of a glowing dot in the scene's pictures [px]

/// The radius of a glowing dot [m], as in the scene's pictures.
double glow_of(const Scene& scene) {
  const double pixels = picture_layout(scene).view.height - 2.0 * picture_margin;
  return scene.picture.dot_radius.value_or(dot_radius) * picture_region(scene).extent(1) / pixels;
}

std::vector<std::uint8_t> map_of(const Coloring& coloring) {
  std::vector<std::uint8_t> map;
  const std::size_t liquids = coloring.liquids.size();
  for (std::size_t k = 0; k < std::size_t(map_size); ++k) {
    const Color c = liquids > 0 ? coloring.liquids[std::min(k, liquids - 1)]
                                : coloring.at(float(k) / (map_size - 1));
    map.insert(map.end(), {c.r, c.g, c.b, 255});
  }
  return map;
}

}  // namespace

Stage stage_of(const Scene& scene) {
  Stage stage;
  stage.flat = scene.dimension() == 2;
  stage.spacing = float(scene.particles.spacing);
  const auto corner = [&](const Vector& v) { return Point{v[0], v[1], stage.flat ? 0 : v[2]}; };
  stage.low = corner(scene.domain.min);
  stage.high = corner(scene.domain.max);
  if (stage.flat && scene.picture.dots == Dots::glow) stage.glow = float(glow_of(scene));
  const Color c = ground_color(scene);
  stage.background = {float(c.r) / 255, float(c.g) / 255, float(c.b) / 255, 1};
  stage.start = start_of(scene, 0);
  stage.parts = parts_of(scene);
  return stage;
}

Shown shown_of(const Frame& frame, const Coloring& coloring, const Stage& stage) {
  Shown shown;
  const std::size_t n = frame.size(), D = std::size_t(frame.dimension);
  const float scale = coloring.high > coloring.low ? 1 / (coloring.high - coloring.low) : 1;
  const bool liquids = !coloring.liquids.empty();
  shown.balls.resize(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < 3; ++d) shown.balls[4 * i + d] = d < D ? frame.x[D * i + d] : 0;
    const float value = coloring.values[i];
    shown.balls[4 * i + 3] = liquids ? (value + 0.5f) / map_size
                                     : std::clamp((value - coloring.low) * scale, 0.0f, 1.0f);
  }
  shown.map = map_of(coloring);
  for (std::size_t i = 0; i < frame.whitewater.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d)
      shown.foam.push_back(d < D ? frame.whitewater.x[D * i + d] : stage.spacing);
  for (const Part& part : stage.parts) {
    const Matrix m = placement_of(part, frame);
    shown.placements.insert(shown.placements.end(), m.begin(), m.end());
  }
  return shown;
}

}  // namespace freshet::view

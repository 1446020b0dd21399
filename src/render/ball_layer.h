// SPDX-License-Identifier: MIT
/// Lit balls in perspective.
#pragma once
#include <vector>

#include "freshet/frame.h"
#include "render/bands.h"
#include "render/camera.h"
#include "render/color.h"

namespace freshet {

/// Shading of a ball: light and a highlight, by the place of the sample on the ball.
class BallShader {
 public:
  explicit BallShader(const View& view);
  Color operator()(const Ball& b, Color c, int x, int y) const;

 private:
  Vec<3, float> light_, up_, half_;
};

/// The visible balls of a picture, in the order of their particles.
class BallLayer {
 public:
  /// `view` has samples as its unit of pictures. Balls of the whitewater and of walls from point
  /// files follow those of the fluid. Without `colors`, only bubbles and walls have balls.
  BallLayer(const Scene& scene, const Frame& fluid, const Coloring* colors, const View& view);

  /// Draws the balls of band k that are nearer than what it shows.
  void draw(Band& band, int k) const;

 private:
  void add(const View& view, Point p, float size, Color color);
  void add_whitewater(const WhitewaterFrame& whitewater, const View& view, float size,
                      bool bubbles_only);
  void add_walls(const Scene& scene, const View& view, float size);

  BallShader shade_;
  std::vector<Ball> all_;
  std::vector<Color> colors_;
  Bands bands_;
};

}  // namespace freshet

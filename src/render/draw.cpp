// SPDX-License-Identifier: MIT
#include "render/draw.h"

#include "render/balls.h"
#include "render/dots.h"
#include "render/overlay.h"

namespace freshet {

Image draw(const Scene& scene, const Frame& fluid, const ColorRanges& ranges, int threads) {
  const Coloring colors = color_particles(scene, fluid, ranges);
  Image image = fluid.dimension == 2 ? draw_dots(scene, fluid, colors)
                                     : draw_balls(scene, fluid, colors, threads);
  draw_overlays(image, scene, fluid.time, colors);
  return image;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "render/draw.h"

#include "render/balls.h"
#include "render/dots.h"
#include "render/overlay.h"
#include "render/water.h"

namespace freshet {

Image draw(const Scene& scene, const Frame& fluid, const ColorRanges& ranges, int threads) {
  if (scene.picture.style == PictureStyle::water) {
    Image image = draw_water(scene, fluid, threads);
    draw_overlays(image, scene, fluid.time, {});
    return image;
  }
  const Coloring colors = color_particles(scene, fluid, ranges);
  Image image = fluid.dimension == 2 ? draw_dots(scene, fluid, colors)
                                     : draw_balls(scene, fluid, colors, threads);
  draw_overlays(image, scene, fluid.time, colors);
  return image;
}

}  // namespace freshet

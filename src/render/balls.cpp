// SPDX-License-Identifier: MIT
#include "render/balls.h"

#include "render/ball_layer.h"
#include "render/share_out.h"
#include "render/stage.h"
#include "scene/model/picture_layout.h"

namespace freshet {

namespace {
constexpr StageStyle ball_stage{.fluid_opacity = 1.2f, .tiles = false};
}

Image draw_balls(const Scene& scene, const Frame& fluid, const Coloring& colors, int threads) {
  const Color ground = ground_color(scene);
  const PictureLayout layout = picture_layout(scene);
  Image image(layout.view.width, layout.view.height, ground);
  const int wide = oversampling * image.width, high = oversampling * image.height;
  const View view(pose_at(scene, fluid.time), wide, high);
  const Stage stage(scene, fluid, view, ground, ball_stage);
  const BallLayer balls(scene, fluid, &colors, view);
  share_out(band_count(high), threads, [&](int k) {
    Band band = band_of(k, wide, high, ground);
    stage.draw(band);
    balls.draw(band, k);
    resolve(band, image);
  });
  Image whole(layout.width, layout.height, ground);
  whole.paste(image, layout.view.left, layout.view.top);
  return whole;
}

}  // namespace freshet

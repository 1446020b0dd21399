// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/report.h"
#include "freshet/scene.h"
#include "render/color.h"

namespace freshet {

/// Blue - yellow - red for t = 0 ... 1, the article's map of speed; beyond, the ends.
Color speed_color(float t);

/// Pixels between the picture's edge and what it shows in 2D.
inline constexpr int picture_margin = 5;

/// The picture of a 2D fluid: dots on the ground, walls in grey, and the lines of a frame. By
/// default the article's: soft dots, coloured by speed over max(0.1, fastest), added up.
Image draw_dots(const Scene& scene, const Frame& fluid, const Coloring& colors);
Image draw_dots(const Scene& scene, const Frame& fluid);

/// Counts the pixels of such a picture on the article's ground.
PictureStatistics picture_statistics(const Image& image);

}  // namespace freshet

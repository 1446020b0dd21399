// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/report.h"
#include "freshet/scene.h"
#include "render/color.h"

namespace freshet {

/// The article's colour map of speed: blue - yellow - red for t, clamped to 0 ... 1.
Color speed_color(float t);

/// The picture of a 2D fluid: dots on the background, walls in grey, and a frame. Without `colors`
/// they are those of the frame alone.
Image draw_dots(const Scene& scene, const Frame& fluid, const Coloring& colors);
Image draw_dots(const Scene& scene, const Frame& fluid);

/// Counts the pixels of a picture on the article's background.
PictureStatistics picture_statistics(const Image& image);

}  // namespace freshet

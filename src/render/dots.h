// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/report.h"
#include "freshet/scene.h"
#include "render/image.h"

namespace freshet {

/// Blue - yellow - red for t = 0 ... 1, the article's map of speed; beyond, the ends.
Color speed_color(float t);

/// The picture of a fluid: in 2D the article's, in 3D seen from the front and above.
Image draw(const Scene& scene, const Frame& fluid);

/// The article's picture of a 2D fluid: soft dots, coloured by speed over max(0.1, fastest), added
/// up on a dark ground, and the lines of a frame.
Image draw_dots(const Scene& scene, const Frame& fluid);

/// Counts the pixels of such a picture.
PictureStatistics picture_statistics(const Image& image);

}  // namespace freshet

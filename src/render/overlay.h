// SPDX-License-Identifier: MIT
#pragma once
#include "render/color.h"

namespace freshet {

/// Draws what picture.time_stamp, scale_bar and color_bar ask for over a picture.
void draw_overlays(Image& image, const Scene& scene, double time, const Coloring& colors);

/// "t = 0.75 s", with as many decimals as tell a hundredth of a run that ends then.
std::string time_words(double time, double end);

/// A round length, 1, 2 or 5 times a power of ten, of at most `most`.
double round_length(double most);

}  // namespace freshet

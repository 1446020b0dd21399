// SPDX-License-Identifier: MIT
#pragma once
#include "render/color.h"

namespace freshet {

/// Draws the time stamp, scale bar and colour bar over a picture, as set in [picture].
void draw_overlays(Image& image, const Scene& scene, double time, const Coloring& colors);

/// A time stamp such as "t = 0.75 s", with enough decimals to resolve a hundredth of `end` [s].
std::string time_words(double time, double end);

/// The largest round length (1, 2 or 5 times a power of ten) up to `most`.
double round_length(double most);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "render/image.h"

namespace freshet {

/// An image whose pixels are indices of at most 256 colours.
struct PalettedImage {
  int width, height;
  std::vector<Color> colors;
  std::vector<std::uint8_t> pixels;  ///< rows from the top
};

/// Reduces the colours by median cut [Heckbert 1982], over a histogram of 32 levels per channel.
PalettedImage reduce_colors(const Image& image);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace freshet {

struct Color {
  std::uint8_t r, g, b;
  bool operator==(const Color&) const = default;
};

/// 8-bit RGB, rows from the top.
struct Image {
  int width, height;
  std::vector<Color> pixels;
  Image(int width, int height, Color fill)
      : width(width), height(height), pixels(std::size_t(width) * std::size_t(height), fill) {}
  Color& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Color& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
  /// Copies `part`, which must fit, to this place.
  void paste(const Image& part, int left, int top) {
    for (int y = 0; y < part.height; ++y)
      std::copy_n(&part.at(0, y), part.width, &at(left, top + y));
  }
  bool holds(int x, int y) const { return x >= 0 && x < width && y >= 0 && y < height; }
};

}  // namespace freshet

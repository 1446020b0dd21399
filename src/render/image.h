// SPDX-License-Identifier: MIT
#pragma once
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
  bool holds(int x, int y) const { return x >= 0 && x < width && y >= 0 && y < height; }
};

}  // namespace freshet

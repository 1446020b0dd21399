// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "render/image.h"

namespace freshet {

/// Samples along a pixel's side. A pixel is the mean of its samples, which smooths edges.
inline constexpr int oversampling = 2;

/// A ball in a picture: centre and radius in samples, distance from the eye and radius [m].
struct Ball {
  float x, y, radius;
  float z, size;
};

/// The depth buffer of some rows of a picture: the nearest ball or surface at each sample.
class Band {
 public:
  /// A sample is the index of a ball, or a colour with the bit `painted`.
  static constexpr std::uint32_t painted = 1u << 31;

  /// Row 0 of the band is row `top` of the picture, both in samples.
  Band(int width, int top, int rows, Color ground)
      : width(width),
        top(top),
        rows(rows),
        depth(std::size_t(width) * std::size_t(rows), std::numeric_limits<float>::infinity()),
        what(depth.size(), code(ground)) {}

  static std::uint32_t code(Color c) {
    return painted | std::uint32_t(c.r) << 16 | std::uint32_t(c.g) << 8 | c.b;
  }
  static Color color(std::uint32_t code) {
    return {std::uint8_t(code >> 16), std::uint8_t(code >> 8), std::uint8_t(code)};
  }
  std::size_t at(int x, int y) const {
    return std::size_t(y - top) * std::size_t(width) + std::size_t(x);
  }
  bool holds(int x, int y) const { return x >= 0 && x < width && y >= top && y < top + rows; }
  void paint(int x, int y, float z, Color c) {
    const std::size_t k = at(x, y);
    if (z >= depth[k]) return;
    depth[k] = z;
    what[k] = code(c);
  }

  /// Draws a ball. Of two balls at equal depth, the first one stays.
  void draw(const Ball& b, std::uint32_t number) {
    const float r2 = b.radius * b.radius, bulge = b.size / b.radius;
    const int first = std::max(top, int(b.y - b.radius)),
              last = std::min(top + rows - 1, int(b.y + b.radius));
    for (int y = first; y <= last; ++y) {
      const float dy = float(y) + 0.5f - b.y, left2 = r2 - dy * dy;
      if (left2 <= 0) continue;
      const float half = std::sqrt(left2);
      const int low = std::max(0, int(std::ceil(b.x - half - 0.5f))),
                high = std::min(width - 1, int(std::floor(b.x + half - 0.5f)));
      float* z = depth.data() + at(0, y);
      std::uint32_t* seen = what.data() + at(0, y);
      for (int x = low; x <= high; ++x) {
        const float dx = float(x) + 0.5f - b.x, rest = left2 - dx * dx;
        const float near = b.z - bulge * std::sqrt(rest > 0 ? rest : 0);
        const bool nearer = near < z[x];
        z[x] = nearer ? near : z[x];  // written in both cases: the loop vectorises without branches
        seen[x] = nearer ? number : seen[x];
      }
    }
  }

  int width, top, rows;
  std::vector<float> depth;  ///< [m] along the line of sight
  std::vector<std::uint32_t> what;
};

/// Computes each pixel of a painted band as the mean of its samples, row by row.
inline void resolve(const Band& band, Image& image) {
  constexpr int n = oversampling * oversampling;
  for (int py = band.top / oversampling; py < (band.top + band.rows) / oversampling; ++py)
    for (int px = 0; px < image.width; ++px) {
      int r = n / 2, g = n / 2, b = n / 2;
      for (int k = 0; k < n; ++k) {
        const int x = oversampling * px + k % oversampling,
                  y = oversampling * py + k / oversampling;
        const Color c = Band::color(band.what[band.at(x, y)]);
        r += c.r;
        g += c.g;
        b += c.b;
      }
      image.at(px, py) = {std::uint8_t(r / n), std::uint8_t(g / n), std::uint8_t(b / n)};
    }
}

}  // namespace freshet

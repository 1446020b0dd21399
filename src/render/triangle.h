// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace freshet {

/// Calls f(x, y, shares) for the cells of a grid, in columns 0 to `width` and rows `top` to
/// `bottom`, whose centres lie in a triangle. `shares` are the barycentric coordinates of the
/// centre.
template <class F>
void for_each_cell(const Vec<2, double> (&t)[3], int width, int top, int bottom, const F& f) {
  const auto across = [](Vec<2, double> a, Vec<2, double> b) { return a.x * b.y - a.y * b.x; };
  const double area = across(t[1] - t[0], t[2] - t[0]);
  if (area == 0) return;
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto cell = [](double a, double least, double most) {
    return int(std::clamp(std::floor(a), least, most));
  };
  for (int y = cell(low, top, bottom); y < cell(high + 1, top, bottom); ++y)
    for (int x = cell(left, 0, width); x < cell(right + 1, 0, width); ++x) {
      const Vec<2, double> p{x + 0.5, y + 0.5};
      const double a = across(t[2] - t[1], p - t[1]) / area,
                   b = across(t[0] - t[2], p - t[2]) / area, c = 1 - a - b;
      if (a >= 0 && b >= 0 && c >= 0) f(x, y, Vec<3, double>{a, b, c});
    }
}

}  // namespace freshet

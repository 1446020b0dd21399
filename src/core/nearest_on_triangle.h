// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "core/vec.h"

namespace freshet {

/// The point of a triangle nearest to x, by the region of its plane that x projects to [Ericson
/// 2005, 5.1.5].
template <class R> Vec<3, R> nearest_on_triangle(const std::array<Vec<3, R>, 3>& t, Vec<3, R> x) {
  const auto& [a, b, c] = t;
  const Vec<3, R> ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const R d1 = dot(ab, ax), d2 = dot(ac, ax), d3 = dot(ab, bx), d4 = dot(ac, bx), d5 = dot(ab, cx),
          d6 = dot(ac, cx);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const R va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac;
}

}  // namespace freshet

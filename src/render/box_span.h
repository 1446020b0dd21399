// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <optional>

#include "render/camera.h"

namespace freshet {

/// The part of a ray within a box, in units of the ray's length.
struct BoxSpan {
  double enter, leave;
  Point face;  ///< outer normal where the ray enters; 0 if it starts in the box
};

/// The span of the ray from `eye`, from the distance `nearest` on; empty if it misses the box.
inline std::optional<BoxSpan> box_span(Point low, Point high, Point eye, Point ray,
                                       double nearest) {
  BoxSpan span{nearest, 1e30, {0, 0, 0}};
  for (int d = 0; d < 3; ++d) {
    const double v = component(ray, d), e = component(eye, d), from = component(low, d),
                 to = component(high, d);
    if (v == 0) {
      if (e < from || e > to) return {};
      continue;
    }
    double a = (from - e) / v, b = (to - e) / v;
    if (a > b) std::swap(a, b);
    if (a > span.enter) {
      span.enter = a;
      span.face = {0, 0, 0};
      component(span.face, d) = v > 0 ? -1 : 1;
    }
    span.leave = std::min(span.leave, b);
  }
  if (span.enter > span.leave) return {};
  return span;
}

}  // namespace freshet

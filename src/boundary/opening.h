// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A flat opening with the normal `direction`. Lengths that are not set are infinite; without any
/// length it is a whole plane.
///
///   direction, across, up     orthogonal unit vectors; up is zero in 2D
///   half_width, half_height   half the size of a slit or a rectangle along `across` and `up` [m]
///   radius                    of a disc [m]
template <int D> struct Opening {
  Vec<D, double> center, direction, across, up;
  double half_width, half_height, radius;

  /// The distance of x in front of the plane, along `direction` [m].
  FRESHET_HD double ahead(Vec<D, double> x) const { return dot(x - center, direction); }
  /// Whether the projection of x onto the plane lies in the opening, enlarged by `margin` [m].
  FRESHET_HD bool covers(Vec<D, double> x, double margin = 0) const {
    const double a = dot(x - center, across), b = dot(x - center, up);
    const double reach = radius + margin;
    return (a < 0 ? -a : a) <= half_width + margin && (b < 0 ? -b : b) <= half_height + margin &&
           a * a + b * b <= reach * reach;
  }
};

/// How a particle that moves from x to x + d crosses the opening: 1 along its direction, -1 against
/// it, 0 not at all. Points on the plane count as in front of it.
template <int D>
FRESHET_HD int passed(const Opening<D>& piece, Vec<D, double> x, Vec<D, double> d) {
  const double from = piece.ahead(x), to = piece.ahead(x + d);
  if ((from < 0) == (to < 0)) return 0;
  if (!piece.covers(x + from / (from - to) * d)) return 0;
  return from < 0 ? 1 : -1;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

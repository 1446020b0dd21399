// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A flat piece across `direction`, or a whole plane where no length bounds it. What is not given
/// is infinite.
///
///   direction, across, up     unit vectors at right angles; no up in 2D
///   half_width, half_height   of a slit or a rectangle, along `across` and `up` [m]
///   radius                    of a disc [m]
template <int D> struct Opening {
  Vec<D, double> center, direction, across, up;
  double half_width, half_height, radius;

  /// How far x is before the piece, along its direction [m].
  FRESHET_HD double ahead(Vec<D, double> x) const { return dot(x - center, direction); }
  /// Whether the piece, `margin` wider, is there where x lies over its plane.
  FRESHET_HD bool covers(Vec<D, double> x, double margin = 0) const {
    const double a = dot(x - center, across), b = dot(x - center, up);
    const double reach = radius + margin;
    return (a < 0 ? -a : a) <= half_width + margin && (b < 0 ? -b : b) <= half_height + margin &&
           a * a + b * b <= reach * reach;
  }
};

/// Which way a particle went through the piece when it flew from x to x + d: 1 along its direction,
/// -1 against it, 0 past it. What ends on the plane is through, what starts on it was.
template <int D>
FRESHET_HD int passed(const Opening<D>& piece, Vec<D, double> x, Vec<D, double> d) {
  const double from = piece.ahead(x), to = piece.ahead(x + d);
  if ((from < 0) == (to < 0)) return 0;
  if (!piece.covers(x + from / (from - to) * d)) return 0;
  return from < 0 ? 1 : -1;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

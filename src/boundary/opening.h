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

/// The displacement along an axis by the shorter way, across its ends where it is periodic.
/// `period` is 0 where the axis does not repeat [m].
FRESHET_HD double shorter_way(double way, double period) {
  if (!(period > 0)) return way;
  return way > period / 2 ? way - period : way < -period / 2 ? way + period : way;
}

/// How often a particle that moved straight from `from` to `to` crosses the opening: along its
/// direction minus against it. It took the shorter way along axes with a period [m].
template <int D>
FRESHET_HD int crossings(const Opening<D>& piece, Vec<D, double> from, Vec<D, double> to,
                         Vec<D, double> period) {
  Vec<D, double> way = to - from;
  bool across_an_end = false;
  for (int k = 0; k < D; ++k) {
    const double flown = component(way, k);
    component(way, k) = shorter_way(flown, component(period, k));
    across_an_end = across_an_end || component(way, k) != flown;
  }
  const int count = passed(piece, from, way);
  // count the part of its path at the other end as well
  return across_an_end ? count + passed(piece, to - way, way) : count;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

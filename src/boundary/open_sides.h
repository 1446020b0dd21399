// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The sides of the domain through which the fluid leaves.
///
/// A particle has left for good if it is beyond an open side by more than two support radii, and
/// its acceleration does not point back through that side. Up to there it acts on the density of a
/// neighbour of a particle inside. A particle that came over an open side and is now outside of a
/// side that is not open has left as well: it cannot fall back into the domain.
///
///   min, max   corners of the domain [m];   support  support radius [m]
///   open       bit mask of the open sides: bit 2k for min and 2k + 1 for max along axis k
///   closed     bit mask of the other sides, without those of periodic axes
template <int D> struct OpenSides {
  Vec<D, double> min, max;
  double support;
  unsigned open, closed;

  /// Whether x is beyond an open side at all, or too far for what is inside.
  FRESHET_HD bool may_have_left(Vec<D, double> x) const {
    return (beyond(x, 2 * support) & open) != 0 || is_over_the_edge(x);
  }
  /// The side through which a particle at x with this acceleration has left for good; -1: none.
  FRESHET_HD int left_through(Vec<D, double> x, Vec<D, double> a) const {
    const unsigned far = beyond(x, 2 * support) & open;
    for (int side = 0; side < 2 * D; ++side) {
      const double inwards = side % 2 ? -component(a, side / 2) : component(a, side / 2);
      if ((far >> side & 1) && !(inwards > 0)) return side;
    }
    if (!is_over_the_edge(x)) return -1;
    int side = 0;
    while (!(beyond(x, 0) & open & 1u << side)) ++side;
    return side;
  }

 private:
  /// The sides that x is beyond by more than `margin` [m].
  FRESHET_HD unsigned beyond(Vec<D, double> x, double margin) const {
    Vec<D, double> low = min, high = max;
    unsigned sides = 0;
    for (int k = 0; k < D; ++k) {
      if (component(x, k) < component(low, k) - margin) sides |= 1u << 2 * k;
      if (component(x, k) > component(high, k) + margin) sides |= 2u << 2 * k;
    }
    return sides;
  }
  /// Whether x is beyond an open side, and half a support radius outside of one that is not open.
  FRESHET_HD bool is_over_the_edge(Vec<D, double> x) const {
    return (beyond(x, 0) & open) != 0 && (beyond(x, support / 2) & closed) != 0;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

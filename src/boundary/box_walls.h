// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Reflection at the sides of a box. A particle outside is moved back and its normal velocity is
/// reversed, v_n -> -restitution v_n [Mueller 2003, section 5: "push them out ... and reflect"]. A
/// restitution e keeps e^2 of the normal kinetic energy: 0.5 loses 75 %.
///
///   min, max     corners of the box [m];   restitution  0 to 1
///   sides        bit mask of the walls: bit 2k for min and 2k + 1 for max along axis k
///   onto_wall    true: the particle is put onto the wall and always reversed, as in the article.
///                false: it is put inside by restitution · overshoot and reversed if outbound
template <int D> struct BoxWalls {
  Vec<D> min, max;
  Real restitution;
  unsigned sides;
  bool onto_wall;

  FRESHET_HD void operator()(Vec<D>& x, Vec<D>& v) const {
    for (int k = 0; k < D; ++k) {
      Vec<D> low = min, high = max;
      if (sides >> 2 * k & 1) side(component(x, k), component(v, k), component(low, k), Real(1));
      if (sides >> (2 * k + 1) & 1)
        side(component(x, k), component(v, k), component(high, k), Real(-1));
    }
  }

 private:
  /// Reflects one component at the side at `wall`; `inward` is +1 or -1, the sign of its inside.
  FRESHET_HD void side(Real& x, Real& v, Real wall, Real inward) const {
    if (!((x - wall) * inward < 0)) return;  // a NaN stays a NaN
    const Real back = wall + restitution * (wall - x);
    x = onto_wall ? wall : back;
    if (onto_wall || v * inward < 0) v *= -restitution;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

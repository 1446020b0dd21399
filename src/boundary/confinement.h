// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/box_walls.h"
#include "boundary/solid.h"
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A shape whose surface reflects particles. A particle at depth -d in the wall is moved to
/// restitution · (-d) in front of the surface. Its normal velocity v_n becomes -restitution v_n if
/// it points into the wall.
template <int D> struct Reflector {
  Solid<D> solid;
  Real restitution;

  FRESHET_HD void operator()(Vec<D>& x, Vec<D>& v) const {
    const Real d = solid.distance(x);
    if (!(d < 0)) return;  // a NaN stays a NaN
    const Vec<D> n = solid.normal(x);
    const Real v_n = dot(v, n);
    x += (-(1 + restitution) * d) * n;
    if (v_n < 0) v += (-(1 + restitution) * v_n) * n;
  }
};

/// Confines particles after a drift: reflecting sides of the domain, reflecting shapes, periodic
/// axes. It records the velocity changes at walls, from which the wall forces follow.
///
///   period      length of each axis that repeats [m], else 0
///   bounced     per place of a particle and wall, the sum of the velocity changes, each over the
///               lightness of its particle [m/s]: the low sides of the domain, its high sides, then
///               each shape; no memory: not noted
template <int D> struct Confinement {
  BoxWalls<D> box;
  Vec<D> period;
  Field<Reflector<D>> shapes;
  int shape_count;
  Field<Vec<D, double>> bounced;
  Liquids liquids;
  int walls() const { return box.sides || shape_count ? 2 + shape_count : 0; }

  /// Moves particle i of f, whose velocity is v.
  FRESHET_HD void operator()(int i, const FluidParticles<D>& f, Vec<D>& v) const {
    Vec<D>& x = f.x[i];
    const double share = bounced.data ? 1 / double(liquids.lightness(f, i)) : 0;
    const Vec<D> before = v;
    if (box.sides) box(x, v);
    if (bounced.data)
      for (int k = 0; k < D; ++k) {
        Vec<D> old = before;
        const Real dv = component(v, k) - component(old, k);
        component(bounced[i * (2 + shape_count) + (dv < 0)], k) += share * double(dv);
      }
    for (int s = 0; s < shape_count; ++s) {
      const Vec<D> old = v;
      shapes[s](x, v);
      if (bounced.data)
        for (int k = 0; k < D; ++k) {
          Vec<D> dv = v - old;
          component(bounced[i * (2 + shape_count) + 2 + s], k) += share * double(component(dv, k));
        }
    }
    for (int k = 0; k < D; ++k) wrap(x, k);
  }

 private:
  FRESHET_HD void wrap(Vec<D>& x, int k) const {
    Vec<D> length = period, low = box.min, high = box.max;
    if (!(component(length, k) > 0)) return;
    if (component(x, k) < component(low, k)) component(x, k) += component(length, k);
    if (component(x, k) >= component(high, k)) component(x, k) -= component(length, k);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

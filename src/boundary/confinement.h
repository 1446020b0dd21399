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
/// Each wall reflects at its nearest face. Where that face lies in another wall, behind a side of
/// the domain, or beyond a wall thinner than the drift, the particle would come out on the wrong
/// side. It then stays where its path first meets a wall.
///
///   period      length of each periodic axis [m], else 0
///   slack       rounding of positions [m]: so far in front of shapes particles stop
///   bounced     per place of a particle and wall, the sum of the velocity changes, each over the
///               lightness of its particle [m/s]: the low sides of the domain, its high sides, then
///               each shape; no memory: not recorded
template <int D> struct Confinement {
  BoxWalls<D> box;
  Vec<D> period;
  Field<Reflector<D>> shapes;
  int shape_count;
  Real slack;
  Field<Vec<D, double>> bounced;
  Liquids liquids;
  int walls() const { return box.sides || shape_count ? 2 + shape_count : 0; }

  /// Confines particle i of f, whose velocity is v and which has just drifted `from` a place.
  FRESHET_HD void operator()(int i, const FluidParticles<D>& f, Vec<D>& v, Vec<D> from) const {
    Vec<D>& x = f.x[i];
    const Vec<D> drift = x - from;
    Vec<D> x_new = x, v_new = v;
    if (box.sides) box(x_new, v_new);
    Real nearest = norm(drift) + 1;
    for (int s = 0; s < shape_count; ++s) {
      nearest = min(nearest, shapes[s].solid.distance(x_new));
      shapes[s](x_new, v_new);
    }
    const bool near = shape_count > 0 && nearest < norm(drift);
    if (near && is_free(from, 2 * slack) && !is_open(from, x_new)) stop(i, f, v, from, drift);
    else bounce(i, f, v);
    for (int k = 0; k < D; ++k) wrap(x, k);
  }

 private:
  /// Whether no wall is nearer than `slack`, less `depth`, at this place. The slack closes the seam
  /// between walls that touch.
  FRESHET_HD bool is_free(Vec<D> x, Real depth = 0) const {
    Vec<D> low = box.min, high = box.max;
    for (int k = 0; k < D; ++k) {
      if ((box.sides >> 2 * k & 1) && component(x, k) < component(low, k) - depth) return false;
      if ((box.sides >> (2 * k + 1) & 1) && component(x, k) > component(high, k) + depth)
        return false;
    }
    for (int s = 0; s < shape_count; ++s)
      if (shapes[s].solid.distance(x) < slack - depth) return false;
    return true;
  }
  /// Whether no wall lies between two places, seen at so many of them.
  static constexpr int samples = 8;
  FRESHET_HD bool is_open(Vec<D> from, Vec<D> to) const {
    for (int k = 1; k <= samples; ++k)
      if (!is_free(from + (Real(k) / samples) * (to - from))) return false;
    return true;
  }

  /// Reflects at each side and shape, and records it.
  FRESHET_HD void bounce(int i, const FluidParticles<D>& f, Vec<D>& v) const {
    Vec<D>& x = f.x[i];
    const Vec<D> before = v;
    if (box.sides) box(x, v);
    for (int k = 0; k < D && bounced.data; ++k) {
      Vec<D> old = before;
      const Real dv = component(v, k) - component(old, k);
      record(i, f, dv < 0, k, dv);
    }
    for (int s = 0; s < shape_count; ++s) {
      const Vec<D> old = v;
      shapes[s](x, v);
      Vec<D> dv = v - old;
      for (int k = 0; k < D && bounced.data; ++k) record(i, f, 2 + s, k, component(dv, k));
    }
  }

  /// Puts a particle where its path first meets a wall, and reflects its velocity there.
  FRESHET_HD void stop(int i, const FluidParticles<D>& f, Vec<D>& v, Vec<D> from,
                       Vec<D> drift) const {
    Real open = 0, closed = 1;
    for (int k = samples; k > 0; --k)
      if (!is_free(from + (Real(k) / samples) * drift)) closed = Real(k) / samples;
    for (int k = 0; k < 10; ++k) {
      const Real middle = (open + closed) / 2;
      (is_free(from + middle * drift) ? open : closed) = middle;
    }
    f.x[i] = from + open * drift;
    reflect_all(i, f, v, from + closed * drift);
    if (open > 0) return;
    for (int k = 0; k < D; ++k) {  // it cannot move at all: back, so that it gains no speed
      if (component(v, k) * component(drift, k) > 0) component(v, k) *= -box.restitution;
    }
  }
  /// Reflects the velocity of a particle that stays in front of a place in one or more walls.
  FRESHET_HD void reflect_all(int i, const FluidParticles<D>& f, Vec<D>& v, Vec<D> x) const {
    Vec<D> low = box.min, high = box.max;
    for (int side = 0; side < 2 * D; ++side) {
      if (!(box.sides >> side & 1)) continue;
      const int k = side / 2;
      const Real d =
          side % 2 ? component(high, k) - component(x, k) : component(x, k) - component(low, k);
      Vec<D> n{};
      component(n, k) = side % 2 ? Real(-1) : Real(1);
      if (!(d > 0)) reflect(i, f, v, n, side % 2, box.restitution);
    }
    for (int s = 0; s < shape_count; ++s)
      if (shapes[s].solid.distance(x) < slack)
        reflect(i, f, v, shapes[s].solid.normal(f.x[i]), 2 + s, shapes[s].restitution);
  }
  FRESHET_HD void reflect(int i, const FluidParticles<D>& f, Vec<D>& v, Vec<D> n, int wall,
                          Real restitution) const {
    const Real v_n = dot(v, n);
    if (!(v_n < 0)) return;
    Vec<D> dv = (-(1 + restitution) * v_n) * n;
    v += dv;
    for (int k = 0; k < D && bounced.data; ++k) record(i, f, wall, k, component(dv, k));
  }

  FRESHET_HD void record(int i, const FluidParticles<D>& f, int wall, int k, Real dv) const {
    component(bounced[i * (2 + shape_count) + wall], k) +=
        1 / double(liquids.lightness(f, i)) * double(dv);
  }
  FRESHET_HD void wrap(Vec<D>& x, int k) const {
    Vec<D> length = period, low = box.min, high = box.max;
    if (!(component(length, k) > 0)) return;
    if (component(x, k) < component(low, k)) component(x, k) += component(length, k);
    if (component(x, k) >= component(high, k)) component(x, k) -= component(length, k);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

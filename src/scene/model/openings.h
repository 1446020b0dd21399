// SPDX-License-Identifier: MIT
/// The openings of inlets and counters.
#pragma once
#include <limits>

#include "boundary/opening.h"
#include "core/inlet_plan.h"
#include "scene/model/solid_of.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The opening must be of a scene with its defaults filled in. Its direction must not be 0.
template <int D> Opening<D> opening_of(const Scene::Opening& o) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Opening<D> piece{};
  piece.center = vec_of<D>(o.center);
  piece.direction = unit_of<D>(o.direction);
  piece.half_width = o.width ? *o.width / 2 : infinity;
  piece.half_height = o.height ? *o.height / 2 : infinity;
  piece.radius = o.radius.value_or(infinity);
  if constexpr (D == 2) {
    piece.across = {-piece.direction.y, piece.direction.x};
  } else {
    const auto up = unit_of<D>(o.up);
    const auto flat = up - dot(up, piece.direction) * piece.direction;
    piece.up = flat / norm(flat);
    piece.across = cross(piece.up, piece.direction);
  }
  return piece;
}

}  // namespace FRESHET_ISA

/// The scene must have its defaults filled in.
InletPlan inlet_plan(const Scene& scene, const Scene::Inlet& inlet);

/// The number of particles that inlets add: in the zones that are filled at the start, and later
/// until the end.
struct InflowEstimate {
  double at_start = 0, later = 0;
};
InflowEstimate estimate_inflow(const Scene& scene);
/// The number of particles that the domain holds at rest density, plus a tenth.
double room_in_domain(const Scene& scene);

/// The region where the inlet sets the motion of the liquid: from the opening to the depth of the
/// zone behind it.
template <int D> struct InletZone {
  Opening<D> opening;
  double depth;
  InletZone(const Scene& scene, const Scene::Inlet& inlet)
      : opening(opening_of<D>(inlet)), depth(inlet_plan(scene, inlet).depth()) {}
  bool holds(Vec<D, double> x, double margin) const {
    const double ahead = opening.ahead(x);
    return ahead < margin && ahead > -depth - margin && opening.covers(x, margin);
  }
};

}  // namespace freshet

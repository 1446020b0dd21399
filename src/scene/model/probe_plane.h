// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "freshet/scene.h"

namespace freshet {

/// The number of intervals between the points of a plane along an axis; 0 along its normal.
inline std::int64_t steps_of_plane(const Scene& s, const Scene::Probe& p, std::size_t axis) {
  const double length = std::abs(p.to[axis] - p.from[axis]);
  const double steps = std::round(length / p.apart.value_or(s.particles.spacing));
  return length > 0 ? std::int64_t(std::min(std::max(steps, 1.0), 1e9)) : 0;
}

/// Steps between the places of a surface probe, four in a spacing. A double, as the ends may be
/// far apart.
inline double steps_of_surface(const Scene& s, const Scene::Probe& p) {
  double length2 = 0;
  for (std::size_t d = 0; d < p.from.size(); ++d)
    length2 += (p.to[d] - p.from[d]) * (p.to[d] - p.from[d]);
  return std::ceil(4 * std::sqrt(length2) / s.particles.spacing);
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/model/setup.h"

namespace freshet {

Triple origin_of(const Scene& s) {
  Triple origin{};
  double extent = 0;
  const std::size_t n = s.domain.max.size();
  for (std::size_t k = 0; k < n; ++k) extent = std::max(extent, s.domain.max[k] - s.domain.min[k]);
  for (std::size_t k = 0; k < n; ++k)
    if (std::max(s.domain.min[k], -s.domain.max[k]) > extent) origin[k] = s.domain.min[k];
  return origin;
}

double farthest_position(const Scene& s) {
  const Triple origin = origin_of(s);
  double far = 0;
  for (std::size_t k = 0; k < s.domain.max.size(); ++k)
    far = std::max(
        {far, std::abs(s.domain.min[k] - origin[k]), std::abs(s.domain.max[k] - origin[k])});
  return far;
}

double rounding_of_positions(const Scene& s) {
  return farthest_position(s) * double(std::numeric_limits<Real>::epsilon());
}

}  // namespace freshet

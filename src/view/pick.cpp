// SPDX-License-Identifier: MIT
#include "view/pick.h"

#include <algorithm>
#include <limits>

namespace freshet::view {

Point position_of(const Frame& frame, std::size_t i) {
  const float* x = frame.x.data() + std::size_t(frame.dimension) * i;
  return {double(x[0]), double(x[1]), frame.dimension == 3 ? double(x[2]) : 0.0};
}

std::optional<std::size_t> pick(const Frame& frame, const Camera::Ray& ray, double radius,
                                const Slice& slice) {
  std::optional<std::size_t> best;
  double nearest = std::numeric_limits<double>::infinity(), closest = nearest;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Point x = position_of(frame, i), arm = x - ray.from;
    const double along = dot(arm, ray.along), off2 = norm2(arm) - along * along;
    if (along <= 0 || !(off2 <= radius * radius) || !slice.holds(x)) continue;
    const double enter = frame.dimension == 2 ? 0 : along - std::sqrt(radius * radius - off2);
    if (enter > nearest || (enter == nearest && off2 >= closest)) continue;
    nearest = enter;
    closest = off2;
    best = i;
  }
  return best;
}

std::optional<std::size_t> find_id(const Frame& frame, std::uint64_t id) {
  const auto at = std::lower_bound(frame.id.begin(), frame.id.end(), id);
  if (at == frame.id.end() || *at != id) return {};
  return std::size_t(at - frame.id.begin());
}

std::vector<std::size_t> neighbors_of(const Frame& frame, std::size_t particle, double support) {
  std::vector<std::size_t> near;
  const Point x = position_of(frame, particle);
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (i != particle && norm2(position_of(frame, i) - x) < support * support) near.push_back(i);
  return near;
}

}  // namespace freshet::view

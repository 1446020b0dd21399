// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "freshet/frame.h"
#include "view/camera.h"

namespace freshet::view {

/// A part of space that is shown: between two planes across an axis.
struct Slice {
  int axis = -1;                     ///< 0 to 2; -1: everything
  double middle = 0, thickness = 0;  ///< [m]
  bool holds(Point x) const {
    if (axis < 0) return true;
    const double at = axis == 0 ? x.x : axis == 1 ? x.y : x.z;
    return at >= middle - thickness / 2 && at <= middle + thickness / 2;
  }
};

Point position_of(const Frame& frame, std::size_t particle);
/// The nearest particle whose ball of this radius [m] the ray meets.
std::optional<std::size_t> pick(const Frame& frame, const Camera::Ray& ray, double radius,
                                const Slice& slice = {});
/// The place of an id in a frame.
std::optional<std::size_t> find_id(const Frame& frame, std::uint64_t id);
/// The particles closer to this one than `support` [m], itself excluded. Periodic images are
/// excluded, too.
std::vector<std::size_t> neighbors_of(const Frame& frame, std::size_t particle, double support);

}  // namespace freshet::view

// SPDX-License-Identifier: MIT
/// The weights of a particle at the points of a block.
#pragma once
#include <algorithm>
#include <cmath>

#include "surface/kernels.h"
#include "surface/spline.h"

namespace freshet {

/// The points of a block along an axis that are closer to `at` than `radius`.
struct BlockPoints {
  int first, last;
  BlockPoints(float at, float radius)
      : first(std::max(0, int(std::ceil(at - radius)))),
        last(std::min(block_cells - 1, int(std::floor(at + radius)))) {}
};

/// Calls add(point, weight) row by row. Points of a row beyond the support get the weight 0.
template <class Add>
void add_round(Vec<3, float> at, Spline spline, float support, const Add& add) {
  const float support2 = support * support;
  for (BlockPoints pz(at.z, support); pz.first <= pz.last; ++pz.first) {
    const float dz = float(pz.first) - at.z, left2 = support2 - dz * dz;
    if (left2 <= 0) continue;
    for (BlockPoints py(at.y, std::sqrt(left2)); py.first <= py.last; ++py.first) {
      const float dy = float(py.first) - at.y, yz2 = dz * dz + dy * dy;
      const auto row = std::size_t(point_index(0, py.first, pz.first));
      for (int x = 0; x < block_cells; ++x) {
        const float dx = float(x) - at.x;
        add(row + std::size_t(x), spline(yz2 + dx * dx));
      }
    }
  }
}

/// As add_round(), for a kernel that has a shape. Along a row, the squared distance in the round
/// kernel is a quadratic function; rows that it does not reach are skipped.
template <class Add>
void add_shaped(Vec<3, float> at, Spline spline, float radius, const KernelShape& shape,
                const Add& add) {
  const float reach = radius * shape.reach, reach2 = reach * reach, radius2 = radius * radius;
  const Vec<3, float> along = shape.shrink * Vec<3, float>{1, 0, 0};
  const float a = norm2(along);
  for (BlockPoints pz(at.z, reach); pz.first <= pz.last; ++pz.first) {
    const float dz = float(pz.first) - at.z, left2 = reach2 - dz * dz;
    if (left2 <= 0) continue;
    for (BlockPoints py(at.y, std::sqrt(left2)); py.first <= py.last; ++py.first) {
      const Vec<3, float> start =
          shape.shrink * Vec<3, float>{-at.x, float(py.first) - at.y, dz};  // of x = 0
      const float b = dot(start, along), c = norm2(start);
      if (c * a - b * b >= radius2 * a) continue;
      const auto row = std::size_t(point_index(0, py.first, pz.first));
      for (int x = 0; x < block_cells; ++x) {
        const float fx = float(x);
        add(row + std::size_t(x), spline(std::max(c + fx * (2 * b + fx * a), 0.0f)));
      }
    }
  }
}

/// The squared distance of a point from a block.
inline float distance2_of_block(Vec<3, float> at) {
  const auto beyond = [](float x) { return std::max({-x, x - float(block_cells), 0.0f}); };
  const Vec<3, float> d{beyond(at.x), beyond(at.y), beyond(at.z)};
  return norm2(d);
}

/// Calls add(point, weight) for the points of a block that a particle near it reaches. `nearby` was
/// collected for the block.
template <class Add>
void for_each_weight(const Kernels& kernels, Spline spline, const Nearby& nearby, std::size_t j,
                     const Add& add) {
  const int particle = nearby.particle[j];
  const Vec<3, float> at{nearby.x[j], nearby.y[j], nearby.z[j]};
  const float reach = kernels.reach(particle);
  if (kernels.is_round(particle)) add_round(at, spline, kernels.radius, add);
  else if (distance2_of_block(at) < reach * reach)
    add_shaped(at, spline, kernels.radius, kernels.shape[std::size_t(particle)], add);
}

}  // namespace freshet

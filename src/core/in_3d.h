// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"
#include "freshet/vector.h"

namespace freshet {

/// A vector of a scene in 2D or 3D as one of space; z is 0 in 2D.
inline Vec<3, double> in_3d(const Vector& a) { return {a[0], a[1], a.size() > 2 ? a[2] : 0}; }

/// The inverse of in_3d.
inline Vector in_scene(Vec<3, double> a, std::size_t dimension) {
  Vector all{a.x, a.y, a.z};
  all.resize(dimension);
  return all;
}

}  // namespace freshet

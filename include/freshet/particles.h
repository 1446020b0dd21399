// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "freshet/real.h"
#include "freshet/vector.h"

namespace freshet {

/// A read-only view of the fluid, valid until the next step. x and v hold `dimension` numbers per
/// particle; every array has the same order.
struct ParticleView {
  int dimension = 2;
  std::span<const std::uint64_t> id;
  std::span<const Real> x, v;      ///< position [m], velocity [m/s]
  std::span<const Real> density;   ///< [kg/m^3], computed in the last step; initially rest density
  std::span<const Real> pressure;  ///< [Pa], computed in the last step
  std::span<const int> liquid;     ///< index in Scene::liquids(); empty for one liquid
  /// Where the domain is far from 0, x is rounded more coarsely than the simulation's positions.
  /// Those are `origin` + `offset` [m]. Elsewhere origin is 0 and offset is empty.
  std::array<double, 3> origin{};
  std::span<const Real> offset{};
  /// Coordinate d of particle i at full precision [m].
  double position(std::size_t i, std::size_t d) const {
    const std::size_t k = std::size_t(dimension) * i + d;
    return offset.empty() ? double(x[k]) : origin[d] + double(offset[k]);
  }
  int liquid_of(std::size_t i) const { return liquid.empty() ? 0 : liquid[i]; }
  std::size_t size() const { return id.size(); }
};

/// The boundary particles of walls and bodies, each with the present force of the fluid on it.
struct BoundaryForces {
  std::vector<double> x;      ///< position, `dimension` numbers per boundary particle [m]
  std::vector<double> force;  ///< `dimension` numbers per boundary particle [N; N/m in 2D]
  /// Index in Scene::wall_names(); for a body the number of these names plus its index in
  /// Scene::body.
  std::vector<int> part;
  std::size_t size() const { return part.size(); }
};

/// A rectangle on a wall; in 2D a line segment on it.
struct WallPatch {
  Vector center;             ///< [m]
  Vector half;               ///< half its lengths along `axes`, 0 along its normal [m]
  std::vector<Vector> axes;  ///< D orthogonal unit vectors
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace freshet {

/// The load of the fluid on the surfaces of walls and bodies at one time. Each point stands for the
/// same `area`; traction times area adds up to the force on a part.
struct SurfacePoints {
  int dimension = 2;
  double area = 0;                 ///< of the surface per point [m²; m in 2D]
  std::vector<float> x;            ///< on the surface, `dimension` numbers per point [m]
  std::vector<float> normal;       ///< towards the fluid, a unit vector; 0 if unknown
  std::vector<float> traction;     ///< force of the fluid over area [Pa]
  std::vector<float> pressure;     ///< minus traction · normal [Pa]
  std::vector<std::int32_t> part;  ///< see BoundaryForces::part
  std::size_t size() const { return part.size(); }
};

}  // namespace freshet

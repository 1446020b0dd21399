// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "freshet/whitewater.h"

namespace freshet {

/// The state of a rigid body at one time, in three dimensions. In a 2D scene z is 0 and the body
/// turns about z. The body's point that started at x0 is at
/// position + orientation (x0 - position at the start).
struct BodyState {
  std::array<double, 3> position{};               ///< of the centre of mass [m]
  std::array<double, 4> orientation{0, 0, 0, 1};  ///< unit quaternion x, y, z, w
  std::array<double, 3> velocity{};               ///< of the centre of mass [m/s]
  std::array<double, 3> angular_velocity{};       ///< [rad/s]
  /// Force and torque of the fluid over the last step, about the centre of mass
  /// [N, N m; in 2D N/m, N m/m]
  std::array<double, 3> force{}, torque{};
};

/// The fluid at one time, for pictures and data files. Particles are in the order of their ids.
/// Values are 32-bit floats, also where Real is double. SI units.
struct Frame {
  int dimension = 2;
  std::int64_t step = 0;
  double time = 0;  ///< [s]
  std::vector<std::uint64_t> id;
  std::vector<float> x, v;               ///< `dimension` numbers per particle: [m], [m/s]
  std::vector<float> density, pressure;  ///< one number per particle, computed in the last step:
                                         ///< [kg/m^3], [Pa]
  std::vector<int> liquid;               ///< index in Scene::liquids(); empty for one liquid
  std::vector<BodyState> bodies;         ///< in the order of Scene::body
  WhitewaterFrame whitewater;            ///< empty in scenes without [whitewater]
  std::size_t size() const { return id.size(); }
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace freshet {

/// A rigid body at one moment, in three dimensions (of a scene in 2D z is 0, and it turns about z).
/// What was at x0 at the start is at position + orientation (x0 - position at the start).
struct BodyState {
  std::array<double, 3> position{};               ///< of its centre of mass [m]
  std::array<double, 4> orientation{0, 0, 0, 1};  ///< a unit quaternion x, y, z, w
  std::array<double, 3> velocity{};               ///< of the centre of mass [m/s]
  std::array<double, 3> angular_velocity{};       ///< [rad/s]
  std::array<double, 3> force{}, torque{};        ///< of the fluid over the last step, about the
                                                  ///< centre of mass [N, N m; in 2D N/m, N]
};

/// The fluid at one moment, for pictures and data files: particles in the order of their ids,
/// 32-bit floats whatever the state is in. SI units.
struct Frame {
  int dimension = 2;
  std::int64_t step = 0;
  double time = 0;
  std::vector<std::uint64_t> id;
  std::vector<float> x, v;               ///< `dimension` numbers a particle: [m], [m/s]
  std::vector<float> density, pressure;  ///< one a particle, as computed in the last step:
                                         ///< [kg/m^D], [Pa; N/m in 2D]
  std::vector<int> liquid;        ///< place in Scene::liquids(); empty where there is but one
  std::vector<BodyState> bodies;  ///< as Scene::body
  std::size_t size() const { return id.size(); }
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>

namespace freshet {

/// The unit of each quantity in tables, files and messages, in ASCII: "kg/m^3". A 2D run is a slice
/// one metre deep, and quantities that grow with the depth are per metre of it.
struct Units {
  const char *time = "s", *length = "m", *speed = "m/s", *angular_velocity = "rad/s";
  const char *density = "kg/m^3", *pressure = "Pa";
  const char *volume, *flow_rate, *mass, *inertia;
  const char *force, *torque, *momentum, *angular_momentum, *energy;
};

constexpr Units units_in(int dimension) {
  Units u{};
  const bool slice = dimension == 2;
  u.volume = slice ? "m^2" : "m^3";  // m^3/m is m^2
  u.flow_rate = slice ? "m^2/s" : "m^3/s";
  u.mass = slice ? "kg/m" : "kg";
  u.inertia = slice ? "kg m^2/m" : "kg m^2";
  u.force = slice ? "N/m" : "N";
  u.torque = slice ? "N m/m" : "N m";
  u.momentum = slice ? "(kg m/s)/m" : "kg m/s";
  u.angular_momentum = slice ? "(kg m^2/s)/m" : "kg m^2/s";
  u.energy = slice ? "J/m" : "J";
  return u;
}

/// A unit with raised exponents, as in messages and pictures: "kg/m³".
inline std::string raised_unit(std::string unit) {
  for (const auto& [plain, raised] : {std::pair("^2", "²"), std::pair("^3", "³")})
    for (auto at = unit.find(plain); at != std::string::npos; at = unit.find(plain))
      unit.replace(at, 2, raised);
  return unit;
}

}  // namespace freshet

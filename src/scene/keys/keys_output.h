// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "freshet/units.h"
#include "scene/keys/keys.h"

namespace freshet {

/// The unit of a key, for both dimensions if they differ: "kg/m in 2D, kg in 3D".
inline std::string key_unit(const char* Units::*quantity) {
  const std::string slice = raised_unit(units_in(2).*quantity),
                    solid = raised_unit(units_in(3).*quantity);
  return slice == solid ? slice : slice + " in 2D, " + solid + " in 3D";
}
inline const std::string density_unit = key_unit(&Units::density),
                         flow_rate_unit = key_unit(&Units::flow_rate),
                         inertia_unit = key_unit(&Units::inertia),
                         mass_unit = key_unit(&Units::mass), torque_unit = key_unit(&Units::torque);

/// The keys that do not change the simulation: output, surface, picture, camera, checks.
void output_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet

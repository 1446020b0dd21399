// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

inline constexpr const char* density_unit = "kg/m² in 2D, kg/m³ in 3D";

/// The keys that do not change the simulation: output, picture, camera, checks.
void output_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

inline constexpr const char* density_unit = "kg/m² in 2D, kg/m³ in 3D";

/// The part of the table that does not change a run: output, picture, camera, checks.
void output_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// Fluids and walls of points: columns that are not used, another spacing than that of the
/// particles, points inside walls. `scene` has its defaults filled in.
std::vector<Diagnostic> point_warnings(const Scene& scene);

}  // namespace freshet

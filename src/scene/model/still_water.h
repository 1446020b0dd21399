// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// The depth of fluid that must stay still, because nothing in the scene can move it [m]: level
/// layers from wall to wall, at rest under hydrostatic pressure. 0 if anything else is in the
/// scene. The scene must have its defaults filled in.
double still_depth(const Scene& scene);

/// The speed that still water of this depth keeps [m/s]. Measured with dfsph; 0 for other solvers
/// and for settings that calm it. docs/solvers.md has the measurement.
double churning_speed(const Scene& scene, double depth);

/// The settings that calm still water.
const char* remedy_for_churning(const Scene& scene);

}  // namespace freshet

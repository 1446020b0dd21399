// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/checkpoint.h"
#include "freshet/scene.h"

namespace freshet {

/// Checks the numbers of a checkpoint that are indices or clocks of this scene: liquids, particles
/// held by inlets, inlets, counts and ids. The arrays must be those of the scene's simulation.
/// Throws Error (kind run) without a place.
void check_restored(const Checkpoint& checkpoint, const Scene& scene);

}  // namespace freshet

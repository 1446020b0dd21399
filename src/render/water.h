// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/image.h"

namespace freshet {

/// The picture of a 3D fluid from the scene's camera as clear liquids: their surface meshes
/// reflect a sky, refract what is behind them, and absorb light by their thickness. It has the same
/// bits with any number of threads.
Image draw_water(const Scene& scene, const Frame& fluid, int threads = 1);

}  // namespace freshet

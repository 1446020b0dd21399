// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/color.h"

namespace freshet {

/// The picture of a 3D fluid from the scene's camera: lit balls of 1.15 spacings in perspective,
/// the walls, and a soft shadow on the floor. It has the same bits with any number of threads.
Image draw_balls(const Scene& scene, const Frame& fluid, const Coloring& colors, int threads = 1);

}  // namespace freshet

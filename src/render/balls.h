// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/color.h"

namespace freshet {

/// The picture of a 3D fluid as the scene's camera sees it: lit balls, a little wider than the
/// spacing, in perspective, among its walls, with a soft shadow on the floor. The same bits with
/// any number of threads.
Image draw_balls(const Scene& scene, const Frame& fluid, const Coloring& colors, int threads = 1);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/image.h"

namespace freshet {

/// The picture of a fluid as the scene's [picture] and [camera] say: dots in 2D, lit balls in 3D,
/// and over them the time, the scale and the colours that were asked for. The same bits with any
/// number of threads.
Image draw(const Scene& scene, const Frame& fluid, int threads = 1);

}  // namespace freshet

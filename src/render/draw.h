// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/color_range.h"
#include "render/image.h"

namespace freshet {

/// The picture of a fluid by the scene's [picture] and [camera]: dots in 2D, lit balls or
/// clear liquids in 3D, with the requested time stamp, scale bar and colour bar. Colours span the
/// ranges of the run up to this frame. The picture has the same bits with any number of threads.
Image draw(const Scene& scene, const Frame& fluid, const ColorRanges& ranges = {}, int threads = 1);

}  // namespace freshet

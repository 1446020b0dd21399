// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"
#include "freshet/scene.h"
#include "render/image.h"

namespace freshet {

/// The picture of a 3D fluid: lit balls, as wide as the spacing and coloured by speed over
/// max(0.1, fastest), in a parallel projection from the front, the right and above, with the edges
/// of the domain.
Image draw_balls(const Scene& scene, const Frame& fluid);

}  // namespace freshet

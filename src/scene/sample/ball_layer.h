// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "boundary/solid.h"
#include "freshet/scene.h"

namespace freshet {

/// Whether the body particles of a ball in 3D are placed by ball_layer(): in the pressure solvers,
/// from a radius of 1 spacing to 12 spacings, where a ball counts as flat.
bool has_ball_layer(const Scene& scene, const Scene::Region& body);

/// The single layer of body particles beneath the surface of a ball. At the depth of a flat layer a
/// small ball would displace too little fluid, because its layer bends away from the fluid. The
/// layer is raised until fluid half a spacing outside sees a density in proportion to the volume
/// inside, as it does at a flat body. It is twice as fine, so that its density is even.
/// docs/bodies.md has the measured buoyancy.
std::vector<Vec<3, double>> ball_layer(const Scene& scene, const Solid<3, double>& ball);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "scene/sample/places.h"

namespace freshet {

/// Fills a fluid up to walls that its lattice does not fit. `x` has the fluid's places, which are
/// half a spacing or more from walls. Adds excluded places near the walls until the volume is the
/// volume asked, and spreads all places near these walls evenly. Returns the number added. Leaves
/// lattices and points as they are given. Bodies count as walls; in a scene with bodies, fewer
/// places are added where they would be too close: around a body less than about ten spacings wide.
template <int D>
std::int64_t fill_to_walls(const Scene& scene, const Scene::Fluid& fluid, const Places<D>& places,
                           std::vector<Vec<D>>& x);

}  // namespace freshet

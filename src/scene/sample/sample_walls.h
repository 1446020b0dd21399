// SPDX-License-Identifier: MIT
#pragma once
#include "scene/model/setup.h"

namespace freshet {

/// Samples the sides of the domain and the walls of a scene with its defaults filled in.
template <int D> void sample_walls(const Scene& scene, Sample& all);

extern template void sample_walls<2>(const Scene&, Sample&);
extern template void sample_walls<3>(const Scene&, Sample&);

/// An upper bound on the number of boundary particles in `layers` layers of a region's surface.
double most_samples(const Scene& scene, const Scene::Region& region, double layers);

/// The number of layers of boundary particles of a method; 0 if it has no boundary particles.
int wall_layers(const Scene& scene, WallMethod method);

}  // namespace freshet

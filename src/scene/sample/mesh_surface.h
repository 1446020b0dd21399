// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/mesh_distance.h"

namespace freshet {

/// Points about `spacing` apart, `depth` behind a mesh's surface; before it if `depth` is negative.
/// No two are nearer than 0.7 spacings, and next to no place of that surface is farther from one
/// [Bridson 2007, Poisson discs]. Where the mesh is thinner than 2 depth they lie in its middle.
std::vector<Vec<3, double>> points_behind(const MeshDistance& mesh, double spacing, double depth);

/// The same in `layers` behind the surface, the first half a spacing and each a spacing deeper,
/// with one point for each cube of a spacing. Where the mesh is too thin for a layer there is none.
std::vector<Vec<3, double>> layers_behind(const MeshDistance& mesh, double spacing, int layers);

}  // namespace freshet

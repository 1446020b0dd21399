// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/mesh_distance.h"

namespace freshet {

/// Points about `spacing` apart, `depth` behind a mesh's surface; before it if `depth` is negative.
/// No two are nearer than 0.7 spacings, and next to no place of that surface is farther from one
/// [Bridson 2007, Poisson discs]. Where the mesh is thinner than 2 depth they lie in its middle.
std::vector<Vec<3, double>> points_behind(const MeshDistance& mesh, double spacing, double depth);

}  // namespace freshet

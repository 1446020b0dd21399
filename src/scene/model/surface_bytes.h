// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/real.h"
#include "freshet/scene.h"

namespace freshet {

/// The number of points of a mesh around particles at `x`, three numbers each, in a grid of cells
/// of one spacing. Marching cubes has a point where a line of the grid enters or leaves the fluid:
/// two for each line that meets a particle. Hidden cavities are not counted.
double points_of_mesh(const std::vector<Real>& x, double spacing);

/// The size of the meshes of one time [bytes], of that many points at cells of one spacing, around
/// that many particles.
double surface_bytes(const SurfaceMeshFiles& files, double points, double particles);

}  // namespace freshet

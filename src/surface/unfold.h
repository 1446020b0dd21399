// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "surface/marching_cubes.h"

namespace freshet {

/// Turns folded triangles of a closed manifold mesh back by swapping their longest edges. Narrow
/// triangles beside the border of a chunk fold when collapses turn them by more than a right angle,
/// each by less. `normals` are of the points on the surface before, of any length.
void unfold(GridMesh& mesh, const std::vector<GridMesh::Point>& normals);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <utility>

#include "mesh/triangle_mesh.h"

namespace freshet {

/// Edges of one triangle only, each from point to point as that triangle passes it.
using OpenEdges = std::vector<std::pair<int, int>>;

/// Closes the holes of a mesh that are narrower than `width` [m], each by the triangles of minimal
/// area [Barequet and Sharir 1995], and adds all holes to `found`. It closes none of them if that
/// took more than a tenth of the mesh's area: sheets and loose triangles have no inside. The
/// triangles must face the same way as their neighbours.
void fill_holes(TriangleMesh& mesh, const OpenEdges& open, double width, MeshCondition& found);

}  // namespace freshet

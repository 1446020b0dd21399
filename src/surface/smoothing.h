// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "surface/marching_cubes.h"

namespace freshet {

/// Where a mesh may be smoothed.
struct Smoothing {
  std::vector<float> weight;          ///< per point, 0 to 1
  std::vector<Vec<3, float>> normal;  ///< unit vectors; zero where a point has none
  int steps = 0;
};

/// Smooths a mesh in place by steps of a weighted Laplacian [Löschner et al. 2023]. A step moves a
/// point to the mean of its neighbours; along its normal, only by the weight. So points spread
/// evenly over droplets, which keep their size.
///
/// The steps are twiced [Tukey 1977]: they smooth the mesh, then smooth what they took from it, and
/// put that back. Ripples go, while shapes that are large beside a cell stay. At the end each
/// connected part gets its volume back by even steps along the normals; a part for which this fails
/// keeps its rough shape.
void smooth(GridMesh& mesh, const Smoothing& smoothing, const Threads& threads);

/// The sum of the area vectors of the triangles around each point [cells²].
std::vector<GridMesh::Point> area_vectors(const GridMesh& mesh);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "surface/marching_cubes.h"

namespace freshet {

/// The connected pieces of the liquid. A piece is bounded by one part of the mesh from outside, and
/// by one for each cavity in it.
struct Pieces {
  std::vector<int> of;         ///< the piece of each point of the mesh
  std::vector<int> particles;  ///< the number of particles in each piece
};

/// Pieces are connected grid points where the field has the level. `mesh` is that of
/// marching_cubes() at this level, with its points still on the edges of the grid.
Pieces pieces_of(const GridMesh& mesh, const DensityField& field, float level,
                 const ParticleBins& bins, const Threads& threads);

/// Moves the points of each piece along their normals, all by the same length up to `farthest`
/// [cells], until it has the volume of its particles, `particle_volume` each [cells³].
void fit_volumes(GridMesh& mesh, const Pieces& pieces, double particle_volume, double farthest);

}  // namespace freshet

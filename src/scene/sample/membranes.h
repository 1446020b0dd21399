// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "mesh/mesh_distance.h"
#include "scene/model/setup.h"

namespace freshet {

/// A surface that no particle may cross. In 2D it is made of strips along z.
struct Membrane {
  MeshDistance surface;
  bool two_sided;  ///< else it holds what comes from outside
  int body = -1;   ///< a body that carries it, which is at its start; -1: it does not move
};

/// The surfaces of solids that are too thin to hold every particle by their boundary particles:
///
/// - meshes with holes, and walls of points, whose near points are joined;
/// - parts of walls and fixed bodies that are thinner than `thin` [m];
/// - parts of other bodies thinner than two spacings, which costs time: thicker ones have a layer
/// of
///   boundary particles on either side.
///
/// Walls are repeated beyond periodic ends. The scene must have its defaults filled in.
std::vector<Membrane> membranes_of(const Scene& scene, double thin);

}  // namespace freshet

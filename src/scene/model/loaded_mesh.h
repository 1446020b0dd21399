// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "freshet/scene.h"
#include "mesh/mesh_distance.h"

namespace freshet {

/// The mesh of a region: read, scaled, rotated, translated and repaired.
struct LoadedMesh {
  std::string file;
  double scale;
  Vector rotation, translation;
  double fill_below;  ///< holes narrower than this are filled [m]
  MeshCondition condition;
  MeshDistance distance;
};

/// Reads the file; throws Error (kind scene) at FILE.
std::shared_ptr<const LoadedMesh> load_mesh(const Scene::Region& region, double fill_below);

/// Loads the mesh of a region into region.loaded if it is not loaded yet. Leaves it empty if the
/// mesh cannot be read, which check_mesh reports.
void remember_mesh(Scene::Region& region, double fill_below);

}  // namespace freshet

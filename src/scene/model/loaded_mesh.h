// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "freshet/scene.h"
#include "mesh/mesh_distance.h"

namespace freshet {

/// The mesh of a region where it stands in the scene: read, scaled, turned, moved and mended.
struct LoadedMesh {
  std::string file;
  double scale;
  Vector rotation, translation;
  MeshCondition condition;
  MeshDistance distance;
};

/// Reads the file; throws Error (kind scene) at FILE.
std::shared_ptr<const LoadedMesh> load_mesh(const Scene::Region& region);

/// Fills in region.loaded where a mesh is asked for and `loaded` is not it; leaves it empty if it
/// cannot be read, which check_mesh tells.
void remember_mesh(Scene::Region& region);

}  // namespace freshet

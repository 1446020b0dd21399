// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "freshet/scene.h"
#include "mesh/mesh_distance.h"
#include "scene/model/outline.h"

namespace freshet {

/// What the surface of a region depends on.
struct MeshSource {
  Shape shape;
  std::string file;
  std::vector<Vector> points;
  std::optional<double> base;
  double scale;
  Vector min, max, rotation, translation;
  double fill_below;  ///< holes narrower than this are filled [m]
  bool operator==(const MeshSource&) const = default;
};

/// The surface of a region as triangles: a mesh read, scaled, rotated, translated and repaired, or
/// a turned box. In 2D, the outline of a polygon or of a turned box, and the prism over it.
struct LoadedMesh {
  MeshSource source;
  MeshCondition condition;
  MeshDistance distance;
  Outline outline;
};

/// Throws Error (kind scene) at FILE.
std::shared_ptr<const LoadedMesh> load_mesh(const Scene::Region& region, double fill_below);

/// Loads the surface of a region into region.loaded if it is not loaded yet. Leaves it empty if
/// that fails, which check_mesh reports.
void remember_mesh(Scene::Region& region, std::size_t dimension, double fill_below);

/// The sides of the box around a loaded surface [m]; z is 0 in 2D.
Vec<3, double> sides_of(const LoadedMesh& mesh);

}  // namespace freshet

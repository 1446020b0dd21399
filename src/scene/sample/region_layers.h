// SPDX-License-Identifier: MIT
/// Boundary particles behind the surface of a region, except of points and planes.
#pragma once
#include "scene/model/region_rotation.h"
#include "scene/sample/mesh_surface.h"
#include "scene/sample/surface.h"

namespace freshet {

/// Turns points that were sampled for the box before its rotation.
template <int D> void turn_with(const Scene::Region& region, std::vector<Vec<D, double>>& points) {
  if (!is_turned_box(region)) return;
  const RegionRotation turned(region.rotation);
  const auto center = solid_of<D>(region).center;
  for (auto& x : points) x = center + turned(x - center);
}

/// Layers behind the outline of a polygon, the first half a spacing and `deeper` behind it.
inline std::vector<Vec<2, double>> layers_of_polygon(const Scene::Region& region, double spacing,
                                                     int layers, double deeper) {
  std::vector<double> depths;
  for (int k = 0; k < layers; ++k) depths.push_back((k + 0.5) * spacing + deeper);
  if (region.side == Side::inside)
    for (double& depth : depths) depth = -depth;
  return points_behind(region.loaded->outline, region.loaded->distance, spacing, depths);
}

}  // namespace freshet

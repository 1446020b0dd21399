// SPDX-License-Identifier: MIT
/// Polygons in 2D.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "freshet/scene.h"
#include "mesh/triangle_mesh.h"

namespace freshet {

using Outline = std::vector<Vec<2, double>>;  ///< corners, counterclockwise

/// The outline of a polygon or box in 2D, or of a disc, which becomes a polygon of 64 corners.
/// Throws Error (kind scene) at FILE.
Outline outline_of(const Scene::Region& region);
/// What is wrong with an outline and what to do.
struct OutlineFault {
  std::string words;
  int corner = -1;  ///< where, if it is at one corner
};
/// Empty if the outline encloses an area.
std::optional<OutlineFault> fault_in(const Outline& outline);
/// Throws Error (kind scene) at the line of the file, or at FILE, if the outline of a region is
/// invalid. FILE is empty for corners of the scene.
void require_valid(const Outline& outline, const Scene::Region& region);

bool encloses(const Outline& outline, Vec<2, double> x);
double perimeter_of(const Outline& outline);

/// The side faces of a prism over an outline; its ends, far below and above z = 0, are open. The
/// distance of a point of that plane from them is that from the outline.
TriangleMesh prism_of(const Outline& outline);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "mesh/mesh_distance.h"
#include "scene/model/outline.h"

namespace freshet {

/// Points about `spacing` apart, `depth` behind a mesh's surface, or in front of it if `depth` is
/// negative. No two are closer than 0.7 spacings, and almost every place of that surface is closer
/// to one than that [Bridson 2007, Poisson discs]. Where the mesh is thinner than 2 depth, or the
/// depth is 0, the points are in its middle and 0.5 spacings apart.
std::vector<Vec<3, double>> points_behind(const MeshDistance& mesh, double spacing, double depth);

/// Points in `layers` layers behind a mesh's surface, with one point per cube of a spacing. The
/// first layer is half a spacing deep, and each further layer is a spacing deeper. Where the mesh
/// is too thin for a layer, the layer has no points. With `fluid_inside` the layers are around it.
std::vector<Vec<3, double>> layers_behind(const MeshDistance& mesh, double spacing, int layers,
                                          bool fluid_inside);

/// Points behind an outline, about `spacing` apart along each of its sides, in layers of these
/// depths; negative depths are in front of it. `prism` is that of the outline. Where the polygon is
/// thinner than 2 depth, the points are in its middle.
std::vector<Vec<2, double>> points_behind(const Outline& outline, const MeshDistance& prism,
                                          double spacing, std::span<const double> depths);

}  // namespace freshet

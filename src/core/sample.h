// SPDX-License-Identifier: MIT
/// The initial particles of a simulation. D numbers per position and velocity. Positions of the
/// fluid and of walls are relative to origin_of() the scene.
#pragma once
#include <cstdint>
#include <vector>

#include "freshet/real.h"

namespace freshet {

/// The boundary particles of one wall method.
struct WallSample {
  std::vector<Real> x;
  /// Index w of the wall in Scene::wall_names(); -1 - w for its images beyond a periodic end.
  std::vector<std::int32_t> wall;
  /// akinci2012: volume over 1/sum_l W_kl, below 1 in walls that are thinner than twice the depth
  /// of the layer.
  std::vector<Real> volume_factor;
};

/// The body particles of all bodies at their initial positions in the scene.
struct BodySample {
  std::vector<double> x;
  std::vector<std::int32_t> body;  ///< index in Scene::body
  std::vector<Real> volume_factor;  ///< as in WallSample; empty for adami2012
};

/// All particles; the ids of the fluid count from 0 in this order.
struct Sample {
  std::vector<Real> x, v;
  std::vector<Real> density;  ///< one per particle [kg/m^3]: rest density, or hydrostatic density
  /// One per particle [Pa]: hydrostatic pressure where the fluid starts hydrostatic, else 0. Empty
  /// if the density already contains it, or if no fluid starts hydrostatic.
  std::vector<Real> pressure;
  std::vector<int> liquid;    ///< one per particle: index in Scene::liquids(); empty for one liquid
  std::int64_t outside = 0;   ///< particles that start outside the domain
  std::int64_t left_out = 0;  ///< lattice sites of fluids that walls exclude
  /// Boundary particles in layers behind the surface. akinci2012: one layer, at the distance of
  /// single_layer_distance(), or in the middle of a thin wall. monaghan2009: one layer, at half a spacing. adami2012: the first
  /// layer at half a spacing, then as many as the support radius reaches.
  WallSample akinci2012, adami2012, monaghan2009;
  BodySample bodies;  ///< in layers beneath the surface, by the wall method of body_method()
};

}  // namespace freshet

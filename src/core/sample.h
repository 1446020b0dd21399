// SPDX-License-Identifier: MIT
/// Where the particles of a simulation start. D numbers per position and velocity.
#pragma once
#include <cstdint>
#include <vector>

#include "freshet/real.h"

namespace freshet {

/// The boundary particles of one wall method.
struct WallSample {
  std::vector<Real> x;
  /// The number w of the wall in Scene::wall_names(); -1 - w beyond a periodic end.
  std::vector<std::int32_t> wall;
};

/// The body particles of all bodies, at their positions at the start.
struct BodySample {
  std::vector<double> x;
  std::vector<std::int32_t> body;  ///< index in Scene::body
};

/// All particles; the ids of the fluid count from 0 in this order.
struct Sample {
  std::vector<Real> x, v;
  std::vector<Real> density;  ///< one per particle [kg/m^D]: rest density, or by its depth
  /// One per particle [Pa]: the weight above it where its fluid is hydrostatic, else 0. Empty if
  /// the density already carries it, or if no fluid is hydrostatic.
  std::vector<Real> pressure;
  std::vector<int> liquid;    ///< one per particle: index in Scene::liquids(); empty for one liquid
  std::int64_t outside = 0;   ///< particles that start outside the domain
  std::int64_t left_out = 0;  ///< lattice places of a fluid that a wall excludes
  /// Layers beyond the surface: one for akinci2012, at its distance; one for monaghan2009, half a
  /// spacing off; for adami2012, from half a spacing on, as many as the support reaches.
  WallSample akinci2012, adami2012, monaghan2009;
  BodySample bodies;  ///< layers beneath the surface, by the method of body_method()
};

}  // namespace freshet

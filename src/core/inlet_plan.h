// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace freshet {

using Triple = std::array<double, 3>;  ///< a vector; in 2D the third component is 0

/// The particles that an inlet emits.
struct InletPlan {
  int dimension = 2;
  std::vector<double> places;  ///< positions of a layer in the opening, D numbers each [m]
  Triple direction{};          ///< unit vector
  double spacing = 0;          ///< distance between layers [m]
  int layers = 0;              ///< number of layers in the zone behind the opening
  double speed = 0;            ///< [m/s]
  double rate = 0;             ///< [m^D/s]
  double start = 0, stop = 0;  ///< [s]
  int liquid = 0;              ///< index in Scene::liquids()
  int outlet = -1;             ///< index of the outlet whose particles it emits again; -1: none

  std::size_t particles() const { return places.size() / std::size_t(dimension); }
  /// Distance from the opening to the back of the zone [m].
  double depth() const { return layers * spacing; }
  /// Number of layers emitted until `time` [s]; half a layer is rounded up.
  double layers_until(double time) const {
    const double flows = std::min(time, stop) - start;
    return flows > 0 ? std::floor(flows * speed / spacing + 0.5 + 1e-9) : 0;
  }
};

}  // namespace freshet

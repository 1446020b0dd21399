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
  std::vector<double> places;  ///< of a layer's particles on the opening, D numbers each [m]
  Triple direction{};          ///< unit vector
  double spacing = 0;          ///< of the layers [m]
  int layers = 0;              ///< that fit into the zone behind the opening
  double speed = 0;            ///< [m/s]
  double rate = 0;             ///< [m^D/s]
  double start = 0, stop = 0;  ///< [s]
  int liquid = 0;              ///< index in Scene::liquids()
  int outlet = -1;             ///< whose particles it emits again, -1: none

  std::size_t particles() const { return places.size() / std::size_t(dimension); }
  /// From the opening to the back of the zone [m].
  double depth() const { return layers * spacing; }
  /// Layers emitted until then; half a layer is rounded up.
  double layers_until(double time) const {
    const double flows = std::min(time, stop) - start;
    return flows > 0 ? std::floor(flows * speed / spacing + 0.5 + 1e-9) : 0;
  }
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Small scenes for tests.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "freshet/scene.h"
#include "scene/model/setup.h"

namespace freshet::test {

/// A scene with these tables and the required keys. `domain` is domain.max.
inline Scene scene_with(const std::string& domain, double spacing, const std::string& tables) {
  return parse_scene("domain.max = " + domain + "\nparticles.spacing = " + std::to_string(spacing) +
                         "\ntime = { end = 0.01, step = 1e-4 }\n" + tables,
                     "test.toml");
}

/// Minimum and maximum distance of the points to their nearest neighbours.
inline std::pair<double, double> nearest_distances(const std::vector<Real>& x, std::size_t d) {
  double least = INFINITY, greatest = 0;
  for (std::size_t i = 0; i < x.size(); i += d) {
    double nearest2 = INFINITY;
    for (std::size_t j = 0; j < x.size(); j += d) {
      double r2 = i == j ? INFINITY : 0;
      for (std::size_t k = 0; k < d; ++k) r2 += std::pow(double(x[i + k]) - double(x[j + k]), 2);
      nearest2 = std::min(nearest2, r2);
    }
    least = std::min(least, std::sqrt(nearest2));
    greatest = std::max(greatest, std::sqrt(nearest2));
  }
  return {least, greatest};
}

}  // namespace freshet::test

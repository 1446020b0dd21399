// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "freshet/scene.h"

namespace freshet {

/// The maximum over the minimum rest density of the liquids.
double density_ratio(const Scene& scene);

/// Ratios of the rest densities of liquids: up to `good` runs succeed, from `hopeless` on all that
/// were tried blow up at any time step. docs/solvers.md has the measurement.
struct DensityRatioLimits {
  double good, hopeless;
};
DensityRatioLimits density_ratio_limits(const Scene& scene);

/// The key of the lightest liquid's density.
std::string key_of_lightest(const Scene& scene);

/// What is wrong with a ratio above `good`, and the remedies.
std::string about_density_ratio(const Scene& scene);

}  // namespace freshet

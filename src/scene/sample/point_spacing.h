// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

namespace freshet {

/// The median distance of points to their nearest neighbours; 0 of fewer than two points. D
/// numbers each. Of many points a thousand are asked.
double median_spacing(const std::vector<double>& x, int dimension);

}  // namespace freshet

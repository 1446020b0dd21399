// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "io/checkpoint.h"

namespace freshet {

/// Adds the values of a step that took dt [s].
void include(IntervalRecord& interval, const std::vector<double>& values, double dt);

/// Names of columns, each after a comma: minimum, maximum, mean, and the integral over time, which
/// is an impulse for a force.
std::string interval_columns(const std::string& name, const std::string& unit);
/// The values of these columns for the quantities from `first` on; NaN where no step had a value.
std::string interval_cells(const IntervalRecord& interval, std::size_t first, std::size_t count);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "run/table.h"

namespace freshet {

/// The values of a formula in the columns of a table, row by row. A column stands in it by its
/// name, with _ for whatever is no letter or digit: "kinetic energy" is kinetic_energy.
/// Throws Error (kind scene), at `place`, where the formula cannot be read.
std::vector<double> evaluate(const std::string& formula, const Table& table,
                             const std::string& place);
/// The same in one variable, for each of its values.
std::vector<double> evaluate(const std::string& formula, const std::string& variable,
                             const std::vector<double>& values, const std::string& place);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "run/table.h"

namespace freshet {

/// The name of a column in formulas, with _ for all but letters and digits: kinetic_energy.
std::string variable_of(const std::string& column);

/// The values of a formula in the columns of a table, row by row.
/// Throws Error (kind scene), at `place`, where the formula cannot be read.
std::vector<double> evaluate(const std::string& formula, const Table& table,
                             const std::string& place);
/// The same in one variable, for each of its values.
std::vector<double> evaluate(const std::string& formula, const std::string& variable,
                             const std::vector<double>& values, const std::string& place);

}  // namespace freshet

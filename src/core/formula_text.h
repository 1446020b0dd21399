// SPDX-License-Identifier: MIT
/// What muParser accepts and a formula must not have.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace freshet {

/// The maximum length of a formula [characters]; muParser has a limit of its own beyond it.
inline constexpr std::size_t longest_formula = 4096;

/// Whether a formula assigns a value to a variable: it has a "=" outside ==, !=, <= and >=.
inline bool assigns(std::string_view formula) {
  for (std::size_t k = 0; k < formula.size(); ++k) {
    if (formula[k] != '=') continue;
    const bool compares = k + 1 < formula.size() && formula[k + 1] == '=';
    const bool ends_operator =
        k > 0 && (formula[k - 1] == '!' || formula[k - 1] == '<' || formula[k - 1] == '>');
    if (!compares && !ends_operator) return true;
    k += compares;
  }
  return false;
}

/// The start of a long text.
inline std::string shortened(std::string_view text, std::size_t most) {
  return std::string(text.substr(0, most)) + (text.size() > most ? "..." : "");
}

/// A formula as an error quotes it.
inline std::string quoted_formula(std::string_view formula) {
  return "\"" + shortened(formula, 80) + "\"";
}

/// The error of a formula before muParser reads it, with the remedy; empty without an error.
inline std::string formula_error(std::string_view formula) {
  if (formula.size() > longest_formula)
    return "is " + std::to_string(formula.size()) + " characters long in " +
           quoted_formula(formula) + "; at most " + std::to_string(longest_formula) +
           " are allowed; shorten it";
  if (assigns(formula))
    return "has an assignment in " + quoted_formula(formula) +
           "; remove it, or compare two values with ==";
  return {};
}

/// The error of a formula with several values, such as "1,5".
inline std::string values_error(std::string_view formula, int values) {
  return "has " + std::to_string(values) + " values in " + quoted_formula(formula) +
         "; exactly one is allowed: write decimals with a point, such as 1.5, and commas only "
         "between the arguments of a function";
}

}  // namespace freshet

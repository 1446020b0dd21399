// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace freshet {

/// A range of numbers along an axis.
struct Range {
  double min = 0, max = 1;
  double span() const { return max - min; }
};

/// The range of an axis for these numbers. It covers all finite numbers, and zero if that is near.
/// It is never empty, also for equal numbers or none.
Range range_of(const std::vector<double>& numbers);
/// The range, widened at both ends, but not across zero.
Range with_margin(Range range);

/// Round numbers within a range and their labels. Large or small numbers have a common factor.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
  std::string factor;  ///< factor of all labels, for example "10³"; empty for 1
};
/// About `about` ticks at a distance of 1, 2 or 5 times a power of ten.
Ticks ticks_of(Range range, int about);

/// A quantity and its unit with raised exponents: axis_title("density", "kg/m^3") is
/// "density [kg/m³]".
std::string axis_title(const std::string& quantity, std::string unit);

/// A label with the factor before its unit: "force [10³ N]".
std::string with_factor(std::string label, const std::string& factor);

/// The indices of the visible points of a line, x and y in points (1/72 inch). They are the first,
/// the lowest, the highest and the last in each half point of width, and all points that are not
/// finite.
std::vector<std::size_t> places_seen(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace freshet

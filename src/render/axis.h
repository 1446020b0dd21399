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

/// What an axis shows of these numbers: all that are finite, with zero where it is near; a range
/// that is not empty even for equal numbers or none.
Range range_of(const std::vector<double>& numbers);
/// The range and a little more at both ends, but not beyond zero.
Range with_margin(Range range);

/// Round numbers within a range, and how they are written: in thousands, thousandths and the like
/// where they are large or small.
struct Ticks {
  std::vector<double> values;
  std::vector<std::string> labels;
  std::string factor;  ///< "10³", which the labels are to be multiplied by; empty for 1
};
/// About so many ticks, 1, 2 or 5 times a power of ten apart.
Ticks ticks_of(Range range, int about);

/// A label whose unit is told that power of ten larger or smaller: "force [10³ N]".
std::string with_factor(std::string label, const std::string& factor);

/// Of very many points of a line, x and y in points, those that a reader could see: of each half
/// point of width the first, the least, the greatest and the last; each that is no finite number.
std::vector<std::size_t> places_seen(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace freshet

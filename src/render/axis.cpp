// SPDX-License-Identifier: MIT
#include "render/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "freshet/units.h"

namespace freshet {
namespace {

/// The smallest round step that divides a range into at most `most` parts.
double round_step(double span, int most) {
  const double least = span / most, power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1, 2, 5})
    if (digit * power >= least * (1 - 1e-9)) return digit * power;
  return 10 * power;
}

/// The power of ten by which the labels of numbers up to `largest` are divided.
int exponent_of(double largest) {
  const int power = int(std::floor(std::log10(largest) + 1e-9));
  return power >= 4 || power <= -3 ? 3 * int(std::floor(power / 3.0)) : 0;
}

std::string factor_of(int exponent) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent == 0) return "";
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

}  // namespace

Range range_of(const std::vector<double>& numbers) {
  Range r{INFINITY, -INFINITY};
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    r.min = std::min(r.min, number);
    r.max = std::max(r.max, number);
  }
  if (r.min > r.max) return {};
  if (r.min > 0 && r.min < 0.4 * r.max) r.min = 0;
  if (r.max < 0 && r.max > 0.4 * r.min) r.max = 0;
  const double size = std::max(std::abs(r.min), std::abs(r.max));
  if (size < 1e-300) return {};          // all numbers are zero
  if (r.span() > 1e-6 * size) return r;  // ticks of a smaller range would differ in no digit
  return {r.min - 0.1 * size, r.max + 0.1 * size};
}

Range with_margin(Range r) {
  const double margin = 0.05 * r.span();
  return {r.min == 0 ? 0 : r.min - margin, r.max == 0 ? 0 : r.max + margin};
}

Ticks ticks_of(Range range, int about) {
  const double step = round_step(range.span(), about);
  const int exponent = exponent_of(std::max(std::abs(range.min), std::abs(range.max)));
  const double unit = std::pow(10, exponent);
  const int decimals = std::max(0, int(-std::floor(std::log10(step / unit) + 1e-9)));
  Ticks ticks;
  ticks.factor = factor_of(exponent);
  const double slack = 1e-9 * range.span();
  for (double k = std::ceil((range.min - slack) / step); k * step <= range.max + slack; ++k) {
    const double value = k == 0 ? 0 : k * step;  // no -0
    ticks.values.push_back(value);
    ticks.labels.push_back((value < 0 ? "−" : "") +
                           fmt::format("{:.{}f}", std::abs(value / unit), decimals));
  }
  return ticks;
}

std::string axis_title(const std::string& quantity, std::string unit) {
  unit = raised_unit(std::move(unit));
  if (unit.empty()) return quantity;
  return quantity + (quantity.empty() ? "[" : " [") + unit + "]";
}

std::string with_factor(std::string label, const std::string& factor) {
  if (factor.empty()) return label;
  const auto unit = label.rfind('[');
  if (unit == std::string::npos) return label + " [" + factor + "]";
  return label.insert(unit + 1, factor + " ");
}

std::vector<std::size_t> places_seen(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::size_t> places;
  for (std::size_t from = 0, to = 0; from < y.size(); from = to) {
    const double column = std::floor(2 * x[from]);
    std::size_t least = from, most = from;
    for (to = from; to < y.size() && std::floor(2 * x[to]) == column && std::isfinite(y[to]);
         ++to) {
      if (y[to] < y[least]) least = to;
      if (y[to] > y[most]) most = to;
    }
    to = std::max(to, from + 1);
    for (const std::size_t place : {from, std::min(least, most), std::max(least, most), to - 1})
      if (places.empty() || places.back() < place) places.push_back(place);
  }
  return places;
}

}  // namespace freshet

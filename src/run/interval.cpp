// SPDX-License-Identifier: MIT
#include "run/interval.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/table.h"

namespace freshet {

namespace {

/// "N s/m" for "N/m".
std::string times_seconds(const std::string& unit) {
  if (unit.empty()) return "s";
  if (unit.ends_with("/s")) return unit.substr(0, unit.size() - 2);
  return std::string(unit).insert(std::min(unit.find('/'), unit.size()), " s");
}

}  // namespace

void include(IntervalRecord& interval, const std::vector<double>& values, double dt) {
  for (auto* numbers : {&interval.low, &interval.high, &interval.integral, &interval.seconds})
    numbers->resize(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isnan(values[k])) continue;
    const bool first = interval.seconds[k] == 0;
    interval.low[k] = first ? values[k] : std::min(interval.low[k], values[k]);
    interval.high[k] = first ? values[k] : std::max(interval.high[k], values[k]);
    interval.integral[k] += dt * values[k];
    interval.seconds[k] += dt;
  }
}

std::string interval_columns(const std::string& name, const std::string& unit) {
  const std::string in = unit.empty() ? "" : fmt::format(" [{}]", unit);
  return fmt::format(",{0},{1},{2},{3}", csv_cell(name + " min" + in), csv_cell(name + " max" + in),
                     csv_cell(name + " mean" + in),
                     csv_cell(fmt::format("{} integral [{}]", name, times_seconds(unit))));
}

std::string interval_cells(const IntervalRecord& interval, std::size_t first, std::size_t count) {
  std::string cells;
  for (std::size_t k = first; k < first + count; ++k) {
    const double seconds = k < interval.seconds.size() ? interval.seconds[k] : 0;
    if (seconds > 0)
      cells += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g}", interval.low[k], interval.high[k],
                           interval.integral[k] / seconds, interval.integral[k]);
    else cells += ",nan,nan,nan,nan";
  }
  return cells;
}

}  // namespace freshet

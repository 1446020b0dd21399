// SPDX-License-Identifier: MIT
#include "run/percentile_table.h"

#include <fmt/format.h>

#include <cmath>

#include "freshet/error.h"
#include "run/table.h"

namespace freshet {
namespace {

/// Calls f(quantity) for each quantity that has columns.
template <class F> void each_quantity(int dimension, F f) {
  for (std::size_t k = 0; k < ColorRanges().size(); ++k)
    if (dimension == 3 || ColorBy(k) != ColorBy::velocity_z) f(k);
}

const std::vector<double>& numbers(const Table& table, const std::filesystem::path& file,
                                   const std::string& name) {
  const Column* column = table.find(name);
  if (!column || (column->of_words() && table.rows > 0))
    throw Error(Error::Kind::scene, file.string() + ":1",
                fmt::format("there is no column \"{}\" of numbers; put the table back as the run "
                            "wrote it, or run the scene again",
                            name));
  return column->numbers;
}

}  // namespace

std::string percentile_header(const Scene& scene) {
  std::string line = "step,time [s]";
  each_quantity(scene.dimension(), [&](std::size_t k) {
    const std::string unit = quantity_unit(ColorBy(k), scene.dimension());
    for (const char* percentile : {"p01", "p99"})
      line += fmt::format(",{} {}{}", quantity_name(ColorBy(k)), percentile,
                          unit.empty() ? "" : " [" + unit + "]");
  });
  return line + "\n";
}

std::string percentile_line(int dimension, std::int64_t step, double time,
                            const ColorRanges& percentiles) {
  std::string line = fmt::format("{},{:.9g}", step, time);
  bool whole = true;
  each_quantity(dimension, [&](std::size_t k) {
    whole = whole && !percentiles[k].is_empty();
    line += fmt::format(",{:.9g},{:.9g}", percentiles[k].low, percentiles[k].high);
  });
  return whole ? line + "\n" : "";
}

namespace {

void require(bool good, const std::filesystem::path& file, std::size_t row, const char* what) {
  if (good) return;
  throw Error(
      Error::Kind::scene, fmt::format("{}:{}", file.string(), row + 2),
      fmt::format("{}; put the table back as the run wrote it, or run the scene again", what));
}

}  // namespace

RangesByStep::RangesByStep(const std::filesystem::path& file, const Scene& scene) {
  const Table table = read_table(file);
  const std::vector<double>& steps = numbers(table, file, "step");
  std::vector<ColorRanges> rows(table.rows);
  each_quantity(scene.dimension(), [&](std::size_t k) {
    const std::string name = quantity_name(ColorBy(k));
    const auto &low = numbers(table, file, name + " p01"),
               &high = numbers(table, file, name + " p99");
    for (std::size_t row = 0; row < rows.size(); ++row) {
      require(low[row] <= high[row] && low[row] >= -3e38 && high[row] <= 3e38, file, row,
              ("the columns of " + name + " are not a range").c_str());
      rows[row][k] = {float(low[row]), float(high[row])};
    }
  });
  ColorRanges sum;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    require(steps[row] >= 0 && steps[row] < 9.1e15, file, row, "the step is not a whole number");
    include(sum, rows[row]);
    steps_[std::llround(steps[row])] = sum;
  }
}

ColorRanges RangesByStep::up_to(std::int64_t step) const {
  const auto after = steps_.upper_bound(step);
  return after == steps_.begin() ? ColorRanges{} : std::prev(after)->second;
}

}  // namespace freshet

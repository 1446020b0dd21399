// SPDX-License-Identifier: MIT
#include "formats/point_arrays.h"

#include <fmt/format.h>

#include "formats/column_names.h"

namespace freshet {
namespace {

bool is_vector(const PointArray& array) { return array.components == 2 || array.components == 3; }

/// The index of the array that holds the velocity; 0, which are the positions, if none does.
std::size_t velocity_among(const std::vector<PointArray>& arrays, const PointSink& sink) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < arrays.size(); ++k) {
    const auto rank = velocity_rank(arrays[k].name);
    if (!rank) continue;
    if (!is_vector(arrays[k]) && always_velocity(arrays[k].name))
      sink.fail(fmt::format("array \"{}\" has {} component{} per point; write 3, or rename it",
                            shown(arrays[k].name), arrays[k].components,
                            arrays[k].components == 1 ? "" : "s"));
    if (is_vector(arrays[k]) && (best == 0 || *rank < *velocity_rank(arrays[best].name))) best = k;
  }
  return best;
}

/// Whether a scalar is a column. Components of a second position or velocity are not.
bool is_column(const PointArray& array, bool has_velocity) {
  const auto column = point_column(array.name);
  return array.components == 1 && (!column || (column->component >= 3 && !has_velocity));
}

}  // namespace

ArrayColumns::ArrayColumns(const std::vector<PointArray>& arrays, PointSink& sink)
    : sink_(sink), first_(arrays.size()), reads_(arrays.size()) {
  static constexpr const char* vectors[][3] = {{"x", "y", "z"}, {"vx", "vy", "vz"}};
  const std::size_t velocity = velocity_among(arrays, sink);
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    const bool vector = k == 0 || k == velocity;
    if (!vector && !is_column(arrays[k], velocity > 0)) {
      sink.skip(arrays[k].name);
      continue;
    }
    reads_[k] = true;
    first_[k] = columns_;
    for (std::size_t c = 0; c < arrays[k].components; ++c)
      sink.name(vector ? vectors[k > 0][c] : short_name(arrays[k].name), columns_++);
  }
  sink.check();
  for (std::size_t k = 0; k < arrays.size(); ++k) reads_[k] = reads_[k] && sink.reads(first_[k]);
}

void ArrayColumns::add(const std::vector<PointArray>& arrays, std::uint64_t points) const {
  std::vector<double> row(columns_);
  for (std::uint64_t i = 0; i < points; ++i) {
    for (std::size_t k = 0; k < arrays.size(); ++k) {
      if (!reads(k)) continue;
      for (std::size_t c = 0; c < arrays[k].components; ++c) {
        const double value = arrays[k].values[i * arrays[k].components + c];
        if (!std::isfinite(value))
          sink_.fail(fmt::format("array \"{}\" is {} at point {}; its values must be finite",
                                 shown(arrays[k].name), value, i));
        row[first_[k] + c] = value;
      }
    }
    sink_.add(row);
  }
}

}  // namespace freshet

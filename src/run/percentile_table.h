// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "render/color_range.h"

namespace freshet {

inline constexpr const char* percentile_file = "percentiles.csv";  // in a run folder

/// The first line of percentiles.csv.
std::string percentile_header(const Scene& scene);
/// A row; empty if a quantity has no values.
std::string percentile_line(int dimension, std::int64_t step, double time,
                            const ColorRanges& percentiles);

/// The colour ranges of a run: for each step with a row, what the rows up to it include.
class RangesByStep {
 public:
  RangesByStep() = default;
  /// Reads percentiles.csv. Throws Error (kind scene) if it is not as the run wrote it.
  RangesByStep(const std::filesystem::path& file, const Scene& scene);
  /// The ranges up to this step; empty before the first row.
  ColorRanges up_to(std::int64_t step) const;
  ColorRanges all() const { return steps_.empty() ? ColorRanges{} : steps_.rbegin()->second; }

 private:
  std::map<std::int64_t, ColorRanges> steps_;
};

}  // namespace freshet

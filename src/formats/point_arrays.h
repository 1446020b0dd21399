// SPDX-License-Identifier: MIT
/// Points in arrays, as VTK and Houdini files hold them.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "formats/point_sink.h"

namespace freshet {

/// An array with one tuple per point.
struct PointArray {
  std::string name;
  std::size_t components = 1;       ///< of a tuple; 0: not numbers
  std::vector<double> values = {};  ///< of all points; empty if the sink does not read them

  bool has_form_of(const PointArray& other) const {
    return name == other.name && components == other.components;
  }
};

/// Feeds a sink from arrays. The first one holds the positions. The best-named vector is the
/// velocity, scalars are columns of their names, and all other arrays are skipped.
class ArrayColumns {
 public:
  /// Names the columns to the sink.
  ArrayColumns(const std::vector<PointArray>& arrays, PointSink& sink);

  /// Whether the sink reads the k-th array.
  bool reads(std::size_t k) const { return reads_[k]; }

  /// Adds the points to the sink. Arrays that the sink reads must have values. Fails for a value
  /// that is not finite.
  void add(const std::vector<PointArray>& arrays, std::uint64_t points) const;

 private:
  PointSink& sink_;
  std::vector<std::size_t> first_;  // column of each array's first component
  std::vector<bool> reads_;
  std::size_t columns_ = 0;
};

}  // namespace freshet

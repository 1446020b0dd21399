// SPDX-License-Identifier: MIT
/// What a data file holds, whatever its format: points at one time, and columns of numbers.
#pragma once
#include <cstdint>
#include <variant>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

/// The fields of a data file in addition to the position.
struct DataFields {
  bool velocity = true, density = true, pressure = true, id = true;
  bool half = false;  ///< HDF5: velocity, density and pressure as 2-byte floats

  DataFields() = default;
  explicit DataFields(const Scene::Output& output);
};

struct PointColumn {
  const char* name;
  const char* unit;
  /// One number per point; a velocity has `dimension` of them.
  std::variant<const std::vector<float>*, const std::vector<std::int32_t>*,
               const std::vector<std::uint64_t>*>
      values;
  bool vectors = false, half = false;
};

/// It refers to the arrays of a frame.
struct PointTable {
  double time;  ///< [s]
  std::int64_t step;
  int dimension;
  const std::vector<float>& x;  ///< `dimension` numbers per point [m]
  std::vector<PointColumn> columns;
  std::size_t size() const { return x.size() / std::size_t(dimension); }
};

PointTable table_of(const Frame& frame, const DataFields& fields);
/// The whitewater of a frame: velocity, id, kind and age.
PointTable whitewater_table(const Frame& frame);

}  // namespace freshet

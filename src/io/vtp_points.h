// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/vtp_arrays.h"

namespace freshet {

/// Points in a VTK XML PolyData file: arrays in raw appended data, a vertex per point. Field data:
/// TimeValue [s], Step, Dimension.
class VtpPoints {
 public:
  VtpPoints(std::size_t points, double time, std::int64_t step, int dimension);

  // Arrays of one number per point, in the order of the file.
  void add(const char* name, const std::vector<float>& values);
  void add(const char* name, const std::vector<std::int32_t>& values);
  void add(const char* name, const std::vector<std::uint64_t>& values);
  /// Adds `dimension` numbers per point as three; z is 0 in 2D.
  void add_vectors(const char* name, const std::vector<float>& values);
  /// The bytes of the file with its points at x.
  std::string bytes_at(const std::vector<float>& x) &&;

 private:
  template <class Index> std::string verts(const char* type);
  std::vector<float> in_space(const std::vector<float>& values) const;

  std::size_t points_;
  int dimension_;
  std::string text_;
  VtpArrays arrays_;
};

}  // namespace freshet

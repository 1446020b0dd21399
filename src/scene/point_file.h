// SPDX-License-Identifier: MIT
/// What the readers of point files share.
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "freshet/error.h"
#include "scene/point_cloud.h"

namespace freshet {

/// Which column of a file holds which number, and what is wrong with it.
class PointColumns {
 public:
  PointColumns(std::string file, int dimension) : file_(std::move(file)), dimension_(dimension) {}

  void name(const std::string& column, std::size_t place);
  void check() const;  ///< after the last name
  bool has_velocity() const;
  /// Whether the column counts; the others may hold anything.
  bool reads(std::size_t place) const {
    return std::find(place_, place_ + 6, std::ptrdiff_t(place)) != place_ + 6;
  }
  /// One point, a value a column.
  void add(const std::vector<double>& values, PointCloud& cloud) const;
  [[noreturn]] void fail(const std::string& why) const;

  std::size_t line = 0;  ///< where the reader stands; 0: no line

 private:
  std::string file_;
  int dimension_;
  std::ptrdiff_t place_[6] = {-1, -1, -1, -1, -1, -1};
};

PointCloud read_ply(std::string_view bytes, PointColumns& columns);
PointCloud read_csv(std::string_view bytes, PointColumns& columns);

/// Takes a line off the front, without its end.
inline std::string_view take_line(std::string_view& bytes) {
  const auto end = std::min(bytes.find('\n'), bytes.size());
  std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(std::min(end + 1, bytes.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// The number that the whole text is.
inline std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (ec != std::errc() || end != text.data() + text.size() || text.empty()) return {};
  return value;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The interface of the parsers of point files. They know neither scenes nor frames.
#pragma once
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"
#include "formats/file_place.h"

namespace freshet {

/// Receives the contents of a point file: first the names of its columns, then a row for each
/// point.
class PointSink : public FilePlace {
 public:
  using FilePlace::FilePlace;
  virtual ~PointSink() = default;

  /// Receives the name of the column with the index `place`.
  virtual void name(const std::string& column, std::size_t place) = 0;
  /// Receives the name of an array that the parser does not read.
  virtual void skip(const std::string&) {}
  /// Called after the last name. Throws if a required column is missing.
  virtual void check() {}
  /// Whether the column is read; the values of other columns are not checked.
  virtual bool reads(std::size_t place) const = 0;
  /// Receives one point, one value per column.
  virtual void add(const std::vector<double>& values) = 0;
  /// Receives a number of the whole file: "time", "step" or "dimension".
  virtual void note(std::string_view, double) {}
};

inline constexpr const char* white_space = " \t\r\n\v\f";

/// Removes the first word from `text` and returns it; empty at the end.
inline std::string_view take_word(std::string_view& text, const char* spaces = " \t") {
  text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
  const auto end = std::min(text.find_first_of(spaces), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

/// The whole text as an unsigned integer; empty if it is not one.
inline std::optional<std::uint64_t> count_in(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (ec != std::errc() || end != text.data() + text.size() || text.empty()) return {};
  return value;
}

/// The line of a place in a text, from 1 on.
inline std::size_t line_at(std::string_view text, std::size_t place) {
  text = text.substr(0, place);
  return 1 + std::size_t(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace freshet

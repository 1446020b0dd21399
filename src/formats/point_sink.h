// SPDX-License-Identifier: MIT
/// What the parsers of point files share; they know neither scenes nor frames.
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

namespace freshet {

/// Takes what a file of points holds: names its columns first, then a row for each point.
class PointSink {
 public:
  explicit PointSink(std::string file) : file_(std::move(file)) {}
  virtual ~PointSink() = default;

  /// The column at `place` has this name.
  virtual void name(const std::string& column, std::size_t place) = 0;
  /// After the last name: throws if one is missing.
  virtual void check() const {}
  /// Whether the column counts; the others may hold anything.
  virtual bool reads(std::size_t place) const = 0;
  /// One point, a value a column.
  virtual void add(const std::vector<double>& values) = 0;
  /// A number of the whole file: "time", "step" or "dimension".
  virtual void note(std::string_view, double) {}

  /// Throws Error (kind scene) at FILE, or FILE:LINE.
  [[noreturn]] void fail(const std::string& why) const;

  std::size_t line = 0;  ///< where the parser stands; 0: no line

 private:
  std::string file_;
};

/// The vertices of a PLY file [Turk 1994]: ascii, or binary of either byte order. Notes are its
/// comments that are a word and a number.
void read_ply(std::string_view bytes, PointSink& sink);
/// The lines of a CSV file, whose first line names the columns: x, or "Points:0" as ParaView does.
void read_csv(std::string_view bytes, PointSink& sink);
/// The points of a VTK XML file of PolyData: ascii, base64 or raw, inline or appended, plain or
/// compressed by zlib. Columns are x, y, z; vx, vy, vz of an array "velocity", "Velocity" or "v";
/// density, pressure and id of arrays of one component. Notes are its field data.
void read_vtp(std::string_view bytes, PointSink& sink);
/// Whether this build reads VTP files: pugixml and zlib were found.
bool reads_vtp();

/// Takes a word off the front; empty at the end.
inline std::string_view take_word(std::string_view& text, const char* spaces = " \t") {
  text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
  const auto end = std::min(text.find_first_of(spaces), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

/// The same of a whole number, 0 or more.
inline std::optional<std::uint64_t> count_in(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, ec] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (ec != std::errc() || end != text.data() + text.size() || text.empty()) return {};
  return value;
}

}  // namespace freshet

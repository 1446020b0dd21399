// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "formats/column_names.h"
#include "formats/point_formats.h"
#include "formats/text_rows.h"

namespace freshet {
namespace {

constexpr const char* coordinates[] = {"x", "y", "z"};
constexpr const char* velocities[] = {"vx", "vy", "vz"};

/// A column of a line: its name, or none for texts and parts of other vectors.
using Names = std::vector<std::string>;

/// The columns that Properties=NAME:TYPE:COUNT:... of extended XYZ declares.
class Properties {
 public:
  Properties(std::string_view text, PointSink& sink) : text_(text), sink_(sink) {}

  Names names() {
    while (!text_.empty()) {
      const std::string_view name = next(), type = next();
      const auto count = count_in(next());
      if (name.empty() || type.empty() || !count || *count == 0 ||
          *count > most_columns - names_.size())
        sink_.fail(
            "Properties= is not a list of NAME:TYPE:COUNT of at most 1024 columns; save the file "
            "again");
      add(name, type, std::size_t(*count));
    }
    return std::move(names_);
  }

 private:
  static constexpr std::uint64_t most_columns = 1024;

  std::string_view next() {
    const std::size_t end = std::min(text_.find(':'), text_.size());
    const std::string_view part = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    return part;
  }
  void add(std::string_view name, std::string_view type, std::size_t count) {
    const bool position = name == "pos" && count == 3;
    const bool velocity = velocity_rank(name) && count == 3;
    const bool scalar = count == 1 && type != "S";
    if (!position && !velocity && !scalar) sink_.skip(std::string(name));
    for (std::size_t k = 0; k < count; ++k)
      names_.push_back(position   ? coordinates[k]
                       : velocity ? velocities[k]
                       : scalar   ? short_name(name)
                                  : "");
  }

  std::string_view text_;
  PointSink& sink_;
  Names names_;
};

/// The value of Properties= in a comment; empty if it is missing.
std::string_view properties_in(std::string_view comment) {
  constexpr std::string_view key = "Properties=";
  const std::size_t at = comment.find(key);
  if (at == std::string_view::npos) return {};
  std::string_view text = comment.substr(at + key.size());
  const bool quoted = text.starts_with('"');
  if (quoted) text.remove_prefix(1);
  return text.substr(0, text.find_first_of(quoted ? "\"" : " \t"));
}

/// Columns without names: perhaps an element, then x, y, z. Other columns are not read.
Names unnamed_columns(std::size_t count, bool element) {
  Names names;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t c = k - element;
    names.push_back(element && k == 0 ? ""
                    : c < 3           ? coordinates[c]
                                      : fmt::format("column {}", k + 1));
  }
  return names;
}

/// The columns of a file with a count whose comment does not name them, by its first point.
Names columns_by(std::string_view line, const PointSink& sink) {
  std::size_t words = 0;
  bool element = false;
  for (std::string_view word; !(word = take_word(line)).empty(); ++words)
    if (words == 0) element = !number_in(word);
  if (words > 3 && !element)
    sink.fail(
        fmt::format("{} unnamed columns of numbers; write Properties=species:S:1:pos:R:3 or "
                    "other columns into line 2, or save it as *.csv",
                    words));
  if (words < 3 + std::size_t(element))
    sink.fail("a point has fewer than 3 coordinates; write an element and x, y, z");
  return unnamed_columns(words, element);
}

/// Reads "COUNT", a comment, and a line per point.
class CountedXyz {
 public:
  CountedXyz(std::string_view bytes, PointSink& sink) : rest_(bytes), sink_(sink) {}

  void read() {
    const auto count = count_in(trimmed(next_line()));
    const std::string_view comment = next_line();
    if (*count > rest_.size()) fail_short(*count, 0);
    if (const auto properties = properties_in(comment); !properties.empty())
      name_columns(Properties(properties, sink_).names());
    for (std::uint64_t k = 0; k < *count; ++k) {
      if (rest_.empty()) fail_short(*count, k);
      add(next_line());
    }
    while (!rest_.empty())
      if (!trimmed(next_line()).empty())
        sink_.fail(
            fmt::format("more lines than the {} points of line 1; save a single frame", *count));
  }

 private:
  std::string_view next_line() {
    ++sink_.line;
    return take_line(rest_);
  }
  [[noreturn]] void fail_short(std::uint64_t count, std::uint64_t points) {
    sink_.fail(fmt::format("line 1 announces {} points, and the file has {}; it is cut off", count,
                           points));
  }
  void name_columns(Names names) {
    names_ = std::move(names);
    for (std::size_t k = 0; k < names_.size(); ++k)
      if (!names_[k].empty()) sink_.name(names_[k], k);
    sink_.check();
    values_.assign(names_.size(), 0);
  }
  void add(std::string_view line) {
    if (names_.empty()) name_columns(columns_by(line, sink_));
    std::size_t words = 0;
    for (std::string_view word; !(word = take_word(line)).empty(); ++words) {
      if (words >= names_.size() || !sink_.reads(words)) continue;
      const auto value = number_in(word);
      if (!value)
        sink_.fail(
            fmt::format("value {} is not a number; write numbers like 0.5 or 1e-3", words + 1));
      values_[words] = *value;
    }
    if (words != names_.size())
      sink_.fail(fmt::format("{} value{} instead of {}; write one per column", words,
                             words == 1 ? "" : "s", names_.size()));
    sink_.add(values_);
  }

  std::string_view rest_;
  PointSink& sink_;
  Names names_;
  std::vector<double> values_;
};

/// Reads lines of columns, perhaps with names.
void read_columns(std::string_view bytes, PointSink& sink) {
  TableText table(bytes);
  sink.line = table.line();
  Names names;
  for (const std::string_view name : table.names()) names.push_back(short_name(name));
  auto first = table.next();
  if (names.empty()) names = unnamed_columns(first.size(), false);
  add_rows(table, std::move(first), names, sink);
}

}  // namespace

void read_xyz(std::string_view bytes, PointSink& sink) {
  std::string_view rest = bytes;
  if (count_in(trimmed(take_line(rest)))) CountedXyz(bytes, sink).read();
  else read_columns(bytes, sink);
}

}  // namespace freshet

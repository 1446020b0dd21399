// SPDX-License-Identifier: MIT
/// Text tables as other programs write them: columns between commas, semicolons, tabs or spaces.
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"

namespace freshet {

/// The first of ; , tab and space that is in a line outside quotes; a comma if none is.
inline char separator_of(std::string_view line) {
  for (const char separator : {';', ',', '\t', ' '}) {
    bool quoted = false;
    for (const char c : trimmed(line)) {
      if (c == '"') quoted = !quoted;
      if (c == separator && !quoted) return separator;
    }
  }
  return ',';
}

/// The fields of a line, without the quotes around them. Several spaces separate like one.
inline std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  std::size_t begin = 0;
  bool quoted = false;
  if (separator == ' ') line = trimmed(line);
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') quoted = !quoted;
    if (at < line.size() && (quoted || line[at] != separator)) continue;
    std::string_view field = trimmed(line.substr(begin, at - begin));
    begin = at + 1;
    if (separator == ' ' && field.empty()) continue;
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
      field = trimmed(field.substr(1, field.size() - 2));
    fields.push_back(field);
  }
  return fields;
}

/// The lines of a table: perhaps comments, which begin with #, then the names of its columns, then
/// its rows. The names may be the last comment.
class TableText {
 public:
  explicit TableText(std::string_view bytes) : rest_(bytes) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    std::string_view comment;
    while (!rest_.empty()) {
      const std::string_view start = rest_, line = trimmed(take_line(rest_));
      ++line_;
      if (line.starts_with('#')) comment = trimmed(line.substr(1));
      if (line.empty() || line.starts_with('#')) continue;
      separator_ = separator_of(line);
      const auto fields = fields_of(line, separator_);
      const auto is_number = [this](std::string_view f) { return number(f).has_value(); };
      if (!std::all_of(fields.begin(), fields.end(), is_number)) {
        names_ = fields;
        return;
      }
      rest_ = start;  // it is a row
      --line_;
      names_ = fields_of(comment, separator_of(comment));
      if (comment.empty() || names_.size() != fields.size()) names_.clear();
      return;
    }
  }

  /// Empty if the table has none.
  const std::vector<std::string_view>& names() const { return names_; }
  /// The fields of the next row; empty at the end.
  std::vector<std::string_view> next() {
    while (!rest_.empty()) {
      const std::string_view line = trimmed(take_line(rest_));
      ++line_;
      if (!line.empty() && !line.starts_with('#')) return fields_of(line, separator_);
    }
    return {};
  }
  /// The number of the last line that was read; 1 before.
  std::size_t line() const { return std::max<std::size_t>(line_, 1); }
  /// A field as a number. Between semicolons a comma may separate the decimals.
  std::optional<double> number(std::string_view field) const {
    const auto comma = field.find(',');
    if (separator_ != ';' || comma == std::string_view::npos ||
        field.find('.') != std::string_view::npos)
      return number_in(field);
    std::string text(field);
    text[comma] = '.';
    return number_in(text);
  }

 private:
  std::string_view rest_;
  std::size_t line_ = 0;
  char separator_ = ',';
  std::vector<std::string_view> names_;
};

/// A name of a column in small letters, without the unit in brackets behind it: "X [m]" is "x".
inline std::string plain_name(std::string_view name) {
  std::string plain(trimmed(name.substr(0, name.find_first_of("[("))));
  for (char& c : plain)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return plain;
}

/// Names of columns as an error lists them, shortened.
template <class Names> std::string listed_names(const Names& names) {
  constexpr std::size_t longest_name = 24, longest_list = 120;
  std::string list;
  for (const auto& name : names) {
    if (list.size() > longest_list) return list + ", ...";
    std::string text(std::string_view(name).substr(0, longest_name));
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
    list += (list.empty() ? "\"" : ", \"") + text + "\"";
  }
  return list.empty() ? "none" : list;
}

}  // namespace freshet

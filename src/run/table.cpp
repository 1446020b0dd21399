// SPDX-License-Identifier: MIT
#include "run/table.h"

#include <fmt/format.h>

#include "core/input_file.h"
#include "core/text.h"
#include "freshet/error.h"

namespace freshet {
namespace {

using Fields = std::vector<std::string>;

constexpr InputFile table_file{.noun = "table", .remedy = "name a CSV file", .may_be_empty = true};

[[noreturn]] void fail(const std::filesystem::path& file, std::size_t line,
                       const std::string& why) {
  throw Error(Error::Kind::scene, fmt::format("{}:{}", file.string(), line), why);
}

/// The fields between commas. A field in quotes may contain commas, and doubled quotes.
Fields fields_of(std::string_view line) {
  Fields fields(1);
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"' && quoted && at + 1 < line.size() && line[at + 1] == '"') {
      fields.back() += line[++at];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

/// "NAME [UNIT]", or a name alone.
Column column_of(const std::string& heading) {
  const auto unit = heading.rfind(" [");
  if (unit == std::string::npos || !heading.ends_with(']')) return {heading, "", {}, {}};
  return {heading.substr(0, unit), heading.substr(unit + 2, heading.size() - unit - 3), {}, {}};
}

/// Turns a column whose fields are all numbers into numbers. A column with a unit must be one.
/// Messages contain no fields: the file may be another than a table.
void settle(Column& column, std::size_t place, const std::filesystem::path& file,
            std::size_t first_line) {
  for (std::size_t row = 0; row < column.words.size(); ++row) {
    const auto number = number_in(column.words[row]);
    if (number) {
      column.numbers.push_back(*number);
    } else if (column.unit.empty()) {
      column.numbers.clear();
      return;
    } else {
      fail(
          file, first_line + row,
          fmt::format("value {} is not a number, and its column has a unit; write numbers only, or "
                      "name the column without a unit",
                      place + 1));
    }
  }
  column.words.clear();
}

}  // namespace

const Column* Table::find(std::string_view name) const {
  for (const Column& column : columns)
    if (column.name == name) return &column;
  return nullptr;
}

Table read_table(const std::filesystem::path& file) {
  const std::string all = read_input(file, table_file);
  std::string_view bytes(all);
  bytes = bytes.substr(0, bytes.rfind('\n') + 1);
  Table table;
  std::size_t line = 1;
  for (; bytes.starts_with('#'); ++line) take_line(bytes);
  if (bytes.empty())
    fail(file, line, "the file has no complete line; the first must name the columns");
  for (const std::string& heading : fields_of(take_line(bytes)))
    table.columns.push_back(column_of(heading));
  while (!bytes.empty()) {
    Fields fields = fields_of(take_line(bytes));
    ++table.rows;
    if (fields.size() != table.columns.size())
      fail(file, table.rows + line,
           fmt::format("{} value{} instead of {}; write one per column", fields.size(),
                       fields.size() == 1 ? "" : "s", table.columns.size()));
    for (std::size_t k = 0; k < fields.size(); ++k)
      table.columns[k].words.push_back(std::move(fields[k]));
  }
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    settle(table.columns[k], k, file, line + 1);
  return table;
}

std::string csv_cell(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"') out += '"';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out + "\"";
}

}  // namespace freshet

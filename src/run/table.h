// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace freshet {

/// A column of a table: numbers, or words if it has no unit and not only numbers.
struct Column {
  std::string name, unit;
  std::vector<double> numbers;     ///< empty if it holds words
  std::vector<std::string> words;  ///< empty if it holds numbers
  bool of_words() const { return !words.empty(); }
};

/// Columns of equal length.
struct Table {
  std::vector<Column> columns;
  std::size_t rows = 0;
  /// The first column of that name, or none.
  const Column* find(std::string_view name) const;
};

/// Reads a CSV file. Comments begin with # and precede the line that names the columns,
/// "NAME [UNIT]". A name with a comma is in quotes. A last line without its end is skipped: a run
/// may be writing it. Throws Error (kind scene) at FILE:LINE if the file is not valid.
Table read_table(const std::filesystem::path& file);

/// A name as a cell of a CSV table of one line per row.
std::string csv_cell(const std::string& name);

}  // namespace freshet

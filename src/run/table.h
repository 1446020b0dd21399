// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace freshet {

/// A column of a table: of numbers, or of words where it has no unit and holds something else.
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

/// Reads a CSV file whose first line, but for comments that begin with #, names the columns,
/// "NAME [UNIT]"; a name with a comma in it
/// stands in quotes. A last line without its end is left out: it is being written, or never was.
/// Throws Error (kind scene) with FILE:LINE where the file is not like that.
Table read_table(const std::filesystem::path& file);

/// A name as a cell of a CSV table of one line per row.
std::string csv_cell(const std::string& name);

}  // namespace freshet

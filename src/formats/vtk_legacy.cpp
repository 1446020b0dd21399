// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cctype>

#include "core/table_text.h"
#include "formats/numbers.h"
#include "formats/point_arrays.h"
#include "formats/point_formats.h"

namespace freshet {
namespace {

constexpr std::size_t most_components = 1024;  // of a tuple; more are damaged files

/// The type of numbers by its name in legacy VTK; of 0 bytes if it is unknown.
NumberType type_named(std::string_view name) {
  static constexpr struct {
    const char* name;
    NumberType type;
  } types[] = {
      {"float", {4, 'f'}},          {"double", {8, 'f'}},        {"char", {1, 'i'}},
      {"signed_char", {1, 'i'}},    {"unsigned_char", {1, 'u'}}, {"short", {2, 'i'}},
      {"unsigned_short", {2, 'u'}}, {"int", {4, 'i'}},           {"unsigned_int", {4, 'u'}},
      {"vtkidtype", {4, 'i'}},      {"long", {8, 'i'}},          {"unsigned_long", {8, 'u'}},
      {"vtktypeint64", {8, 'i'}},   {"vtktypeuint64", {8, 'u'}}};
  for (const auto& known : types)
    if (name == known.name) return known.type;
  return {};
}

/// The name of an array, in which %20 is a space.
std::string decoded_name(std::string_view name) {
  std::string text;
  for (std::size_t k = 0; k < name.size(); ++k) {
    unsigned code = 0;
    const char* digits = name.data() + k + 1;
    const bool encoded = name[k] == '%' && name.size() - k > 2 &&
                         std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
    text += encoded ? char(code) : name[k];
    if (encoded) k += 2;
  }
  return text;
}

/// The words and blocks of numbers of a legacy VTK file.
class LegacyText {
 public:
  LegacyText(std::string_view bytes, PointSink& sink) : all_(bytes), rest_(bytes), sink_(sink) {}

  bool binary = false;  ///< the blocks of numbers are binary

  /// The numbers of an array in the file, not yet decoded.
  struct Block {
    std::string_view bytes;
    std::uint64_t count = 0;
    NumberType type = {};
  };

  /// Fails at the last word; in a file with binary data, without a line.
  [[noreturn]] void fail(const std::string& why) {
    sink_.line = has_binary_ ? 0 : line_at(all_, std::size_t(place_.data() - all_.data()));
    sink_.fail(why);
  }

  std::string_view line() { return place_ = take_line(rest_); }
  std::string_view word() {
    const std::string_view word = take_word(rest_, white_space);
    if (!word.empty()) place_ = word;
    return word;
  }
  std::string small_word() { return plain_name(word()); }
  /// Removes the next word if it is this one in small letters.
  bool takes(std::string_view keyword) {
    std::string_view ahead = rest_;
    const std::string_view word = take_word(ahead, white_space);
    if (word.size() != keyword.size() || plain_name(word) != keyword) return false;
    rest_ = ahead;
    return true;
  }
  std::uint64_t count(std::string_view of) {
    const auto value = count_in(word());
    if (!value) fail(fmt::format("{} has no valid count; save the file again", of));
    return *value;
  }
  NumberType type(std::string_view of) {
    const NumberType type = type_named(small_word());
    if (type.bytes == 0)
      fail(fmt::format("{} must have a numeric type such as float; save the file again without it",
                       of));
    return type;
  }
  /// Moves to the numbers: binary ones begin in the next line.
  void begin_block() {
    if (binary) take_line(rest_);
  }
  Block block(std::string_view of, std::uint64_t tuples, std::uint64_t components, NumberType type);
  std::vector<double> numbers(const std::string& name, const Block& block);

 private:
  std::string_view all_, rest_;
  std::string_view place_ = all_;  // the last word
  bool has_binary_ = false;        // a binary block has been read
  PointSink& sink_;
};

/// Removes a block of numbers. Fails if the file is too short for it.
LegacyText::Block LegacyText::block(std::string_view of, std::uint64_t tuples,
                                    std::uint64_t components, NumberType type) {
  if (components == 0 || components > most_components)
    fail(fmt::format("{} has {} components per tuple; 1 to {} are allowed", of, components,
                     most_components));
  const std::uint64_t least = components * (binary ? type.bytes : 2);  // a digit and a space
  if (tuples > (rest_.size() + !binary) / least)
    fail(fmt::format("{} has {} tuples, and the file is too short; it is cut off", of, tuples));
  Block block{rest_, tuples * components, type};
  if (binary) {
    has_binary_ = has_binary_ || block.count > 0;
    rest_.remove_prefix(block.count * type.bytes);
  } else {
    for (std::uint64_t k = 0; k < block.count; ++k) {
      const std::string_view number = word();
      if (number.empty()) fail(fmt::format("{} ends too early; the file is cut off", of));
      // the keyword of the next section, if values are missing
      if (std::isalpha(static_cast<unsigned char>(number[0])) && !number_in(number))
        fail(fmt::format("{}: value {} is not a number; save the file again", of, k));
    }
  }
  block.bytes.remove_suffix(rest_.size());
  return block;
}

std::vector<double> LegacyText::numbers(const std::string& name, const Block& block) {
  if (binary) return numbers_in(block.bytes, block.type, true);
  std::string_view rest = block.bytes;
  std::vector<double> values = take_numbers(rest, block.count);
  if (values.size() < block.count) {
    place_ = rest;
    fail(fmt::format("array \"{}\": value {} is not a finite number; save the file again",
                     shown(name), values.size()));
  }
  return values;
}

/// Reads the sections of a file: a keyword each, and what belongs to it.
class LegacyReader {
 public:
  LegacyReader(std::string_view bytes, PointSink& sink) : text_(bytes, sink), sink_(sink) {}

  void read() {
    read_header();
    for (std::string word; !(word = text_.small_word()).empty();)
      if (!read_geometry(word) && !read_attribute(word))
        text_.fail(fmt::format("unknown keyword \"{}\"; save the file again", shown(word)));
    sink_.line = 0;
    if (arrays_.empty()) sink_.fail("the file has no POINTS; save it again");
    const ArrayColumns columns(arrays_, sink_);
    for (const std::string& name : cell_arrays_) sink_.skip(name);
    for (std::size_t k = 0; k < arrays_.size(); ++k)
      if (columns.reads(k)) arrays_[k].values = text_.numbers(arrays_[k].name, blocks_[k]);
    columns.add(arrays_, points_);
  }

 private:
  enum class Section { data_set, points, cells };

  void read_header();
  bool read_geometry(std::string_view keyword);
  bool read_attribute(std::string_view keyword);
  void read_cells();
  void begin_section(Section section);
  void read_scalars();
  void read_field();
  void read_array(std::string_view name, std::uint64_t components, NumberType type,
                  std::uint64_t tuples) {
    text_.begin_block();
    read_block(name, components, type, tuples);
  }
  void read_block(std::string_view name, std::uint64_t components, NumberType type,
                  std::uint64_t tuples);
  void skip_information();

  LegacyText text_;
  PointSink& sink_;
  Section section_ = Section::data_set;
  std::uint64_t points_ = 0, cells_ = 0;
  std::vector<PointArray> arrays_;         // the positions first
  std::vector<LegacyText::Block> blocks_;  // of these arrays
  std::vector<std::string> cell_arrays_;
};

void LegacyReader::read_header() {
  if (!text_.line().starts_with("# vtk DataFile Version"))
    text_.fail("not legacy VTK: the first line is not \"# vtk DataFile Version\"; check the file");
  text_.line();  // the title
  const std::string storage = text_.small_word();
  text_.binary = storage == "binary";
  if (!text_.binary && storage != "ascii")
    text_.fail("line 3 must be ASCII or BINARY; save the file again");
  if (text_.small_word() != "dataset") text_.fail("DATASET is missing; save the file again");
  const std::string type = text_.small_word();
  if (type != "polydata" && type != "unstructured_grid")
    text_.fail(
        fmt::format("DATASET is \"{}\" and must be POLYDATA or UNSTRUCTURED_GRID; save the points "
                    "as one of them",
                    shown(type)));
}

/// Reads a section that is not an attribute of points or cells. Returns false for other keywords.
bool LegacyReader::read_geometry(std::string_view keyword) {
  if (keyword == "points") {
    if (!arrays_.empty()) text_.fail("POINTS occurs twice; save the points as one data set");
    points_ = text_.count("POINTS");
    const NumberType type = text_.type("POINTS");
    text_.begin_block();
    arrays_.push_back({"points", 3});
    blocks_.push_back(text_.block("POINTS", points_, 3, type));
  } else if (keyword == "vertices" || keyword == "lines" || keyword == "polygons" ||
             keyword == "triangle_strips" || keyword == "cells") {
    read_cells();
  } else if (keyword == "cell_types") {
    const std::uint64_t cells = text_.count("CELL_TYPES");
    text_.begin_block();
    text_.block("CELL_TYPES", cells, 1, {4, 'i'});
  } else if (keyword == "point_data" || keyword == "cell_data") {
    begin_section(keyword == "point_data" ? Section::points : Section::cells);
  } else if (keyword == "field") {
    read_field();
  } else if (keyword == "metadata") {
    skip_information();
  } else {
    return false;
  }
  return true;
}

/// Skips a list of cells: numbers of corners and corners, or since version 5 offsets and corners.
void LegacyReader::read_cells() {
  const std::uint64_t first = text_.count("a list of cells"),
                      second = text_.count("a list of cells");
  text_.begin_block();
  if (!text_.takes("offsets")) {
    text_.block("a list of cells", second, 1, {4, 'i'});
    return;
  }
  const NumberType offset = text_.type("OFFSETS");
  text_.begin_block();
  text_.block("OFFSETS", first, 1, offset);
  if (text_.small_word() != "connectivity")
    text_.fail("CONNECTIVITY is missing; save the file again");
  const NumberType corner = text_.type("CONNECTIVITY");
  text_.begin_block();
  text_.block("CONNECTIVITY", second, 1, corner);
}

void LegacyReader::begin_section(Section section) {
  section_ = section;
  if (section == Section::cells) {
    cells_ = text_.count("CELL_DATA");
    return;
  }
  if (arrays_.empty()) text_.fail("POINT_DATA precedes POINTS; save the file again");
  const std::uint64_t count = text_.count("POINT_DATA");
  if (count != points_)
    text_.fail(fmt::format("POINT_DATA is {}, and the number of points is {}; save the file again",
                           count, points_));
}

/// Reads an attribute of points or cells. Returns false for other keywords.
bool LegacyReader::read_attribute(std::string_view keyword) {
  static constexpr struct {
    const char* keyword;
    std::uint64_t components;  // 0: a number behind the name
  } attributes[] = {
      {"vectors", 3},    {"normals", 3},      {"tensors", 9},    {"tensors6", 6},
      {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}, {"texture_coordinates", 0}};
  if (section_ == Section::data_set) return false;
  const std::uint64_t tuples = section_ == Section::points ? points_ : cells_;
  const NumberType color{text_.binary ? 1u : 4u, text_.binary ? 'u' : 'f'};
  if (keyword == "scalars") return read_scalars(), true;
  if (keyword == "color_scalars") {
    const std::string_view name = text_.word();
    const std::uint64_t components = text_.count("COLOR_SCALARS");
    return read_array(name, components, color, tuples), true;
  }
  if (keyword == "lookup_table") {
    text_.word();  // its name
    const std::uint64_t colors = text_.count("LOOKUP_TABLE");
    text_.begin_block();
    return text_.block("LOOKUP_TABLE", colors, 4, color), true;
  }
  for (const auto& attribute : attributes) {
    if (keyword != attribute.keyword) continue;
    const std::string_view name = text_.word();
    const std::uint64_t components =
        attribute.components ? attribute.components : text_.count("TEXTURE_COORDINATES");
    const NumberType type = text_.type(fmt::format("array \"{}\"", shown(name)));
    return read_array(name, components, type, tuples), true;
  }
  return false;
}

/// "SCALARS NAME TYPE [COMPONENTS]", perhaps followed by "LOOKUP_TABLE NAME".
void LegacyReader::read_scalars() {
  const std::string_view name = text_.word();
  const NumberType type = text_.type(fmt::format("array \"{}\"", shown(name)));
  const std::string_view behind = trimmed(text_.line());
  const auto components = behind.empty() ? 1 : count_in(behind);
  if (!components)
    text_.fail(fmt::format("array \"{}\" has no valid number of components; save the file again",
                           shown(name)));
  if (text_.takes("lookup_table")) {
    text_.word();  // its name
    text_.begin_block();
  }
  read_block(name, *components, type, section_ == Section::points ? points_ : cells_);
}

/// Reads the numbers of an array. Keeps their place if it belongs to the points.
void LegacyReader::read_block(std::string_view name, std::uint64_t components, NumberType type,
                              std::uint64_t tuples) {
  const LegacyText::Block block =
      text_.block(fmt::format("array \"{}\"", shown(name)), tuples, components, type);
  if (section_ == Section::cells) cell_arrays_.push_back(decoded_name(name));
  if (section_ != Section::points) return;
  arrays_.push_back({decoded_name(name), std::size_t(components)});
  blocks_.push_back(block);
}

/// Reads the arrays of a field; those outside of points and cells are skipped.
void LegacyReader::read_field() {
  text_.word();  // its name
  for (std::uint64_t arrays = text_.count("FIELD"); arrays > 0; --arrays) {
    const std::string_view name = text_.word();
    if (name.empty()) text_.fail("FIELD has fewer arrays than its count; the file is cut off");
    if (name == "NULL_ARRAY") continue;
    const std::string array = fmt::format("array \"{}\"", shown(name));
    const std::uint64_t components = text_.count(array), tuples = text_.count(array);
    const NumberType type = text_.type(array);
    if (section_ == Section::points && tuples != points_)
      text_.fail(
          fmt::format("{} has {} tuples, and the number of points is {}; save the file again",
                      array, tuples, points_));
    read_array(name, components, type, tuples);
    if (text_.takes("metadata")) skip_information();
  }
}

void LegacyReader::skip_information() {
  text_.line();
  while (!trimmed(text_.line()).empty()) {
  }
}

}  // namespace

void read_vtk(std::string_view bytes, PointSink& sink) { LegacyReader(bytes, sink).read(); }

}  // namespace freshet

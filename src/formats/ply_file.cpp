// SPDX-License-Identifier: MIT
#include "formats/ply_file.h"

#include <fmt/format.h>

#include <cmath>

#include "formats/point_sink.h"

namespace freshet {
namespace {

NumberType type_of(std::string_view name) {
  if (name == "char" || name == "int8") return {1, 'i'};
  if (name == "uchar" || name == "uint8") return {1, 'u'};
  if (name == "short" || name == "int16") return {2, 'i'};
  if (name == "ushort" || name == "uint16") return {2, 'u'};
  if (name == "int" || name == "int32") return {4, 'i'};
  if (name == "uint" || name == "uint32") return {4, 'u'};
  if (name == "float" || name == "float32") return {4, 'f'};
  if (name == "double" || name == "float64") return {8, 'f'};
  return {};
}

PlyFormat read_format(std::string_view words, const FilePlace& place) {
  const std::string_view name = take_word(words);
  if (name == "ascii") return PlyFormat::ascii;
  if (name == "binary_little_endian") return PlyFormat::little;
  if (name == "binary_big_endian") return PlyFormat::big;
  place.fail("the format is unknown; save it as ascii or binary_little_endian PLY");
}

PlyElement read_element(std::string_view words, const FilePlace& place) {
  PlyElement element;
  element.name = take_word(words);
  const auto count = count_in(take_word(words));
  if (!count) place.fail("an element has no count; save the file again");
  element.count = *count;
  return element;
}

/// "TYPE NAME" or "list TYPE TYPE NAME".
PlyProperty read_property(std::string_view words) {
  PlyProperty p;
  std::string_view type = take_word(words);
  p.is_list = type == "list";
  if (p.is_list) {
    p.length = type_of(take_word(words));
    type = take_word(words);
  }
  p.type = type_of(type);
  p.name = take_word(words);
  return p;
}

std::string rows_word(const PlyElement& element) {
  return element.name == "vertex" ? "vertices"
         : element.name == "face" ? "faces"
                                  : fmt::format("elements \"{}\"", shown(element.name));
}

}  // namespace

PlyHeader read_ply_header(std::string_view& bytes, FilePlace& place, const PlyEvents& events) {
  PlyHeader h;
  bool has_format = false;
  place.line = 1;
  if (trimmed(take_line(bytes)) != "ply")
    place.fail("not PLY: the first line is not \"ply\"; check the file");
  while (!bytes.empty()) {
    std::string_view line = take_line(bytes);
    ++place.line;
    const std::string_view key = take_word(line);
    if (key == "end_header") {
      if (!has_format) place.fail("the header has no format; save the file again");
      return h;
    }
    if (key == "comment" && events.comment) events.comment(line);
    else if (key == "format") {
      h.format = read_format(line, place);
      has_format = true;
    } else if (key == "element") {
      h.elements.push_back(read_element(line, place));
      if (events.element) events.element(h.elements.back());
    } else if (key == "property") {
      if (h.elements.empty()) place.fail("a property precedes all elements; save the file again");
      PlyElement& element = h.elements.back();
      element.properties.push_back(read_property(line));
      if (events.property) events.property(element, element.properties.back());
    }
  }
  place.fail("end_header is missing; the file is cut off");
}

void PlyRows::begin(const PlyElement& element) {
  const bool ascii = format_ == PlyFormat::ascii;
  std::size_t least = 0;  // bytes of a row
  for (const PlyProperty& p : element.properties) {
    if (p.type.bytes == 0 || (p.is_list && (p.length.bytes == 0 || p.length.kind == 'f')))
      place_.fail(fmt::format("the property \"{}\" of \"{}\" has an unknown type; save it without",
                              shown(p.name), shown(element.name)));
    // an ascii number takes at least two characters; the last separator may be missing
    least += ascii ? 2 : p.is_list ? p.length.bytes : p.type.bytes;
  }
  if (ascii) least = std::max<std::size_t>(least, 1);
  if (least > 0 && element.count > (bytes_.size() + ascii) / least) {
    place_.line = 0;
    place_.fail(fmt::format("the header announces {} {}, and the file is too short; it is cut off",
                            element.count, rows_word(element)));
  }
  values_.values.assign(element.properties.size(), 0);
  values_.lists.assign(element.properties.size(), {});
}

void PlyRows::next(const PlyElement& element) {
  if (format_ == PlyFormat::ascii) return next_ascii(element);
  place_.line = 0;
  next_binary(element);
}

/// The length of a list, if there is room for so many entries.
std::size_t PlyRows::length(const PlyElement& element, double entries, std::size_t room) const {
  if (!(entries >= 0 && entries == std::floor(entries)))
    place_.fail(fmt::format("{} {} has a list of {} entries; the file is damaged",
                            shown(element.name), row_, entries));
  if (entries > double(room))
    place_.fail(fmt::format("{} {} has a list of {} entries, and {} is too short; it is cut off",
                            shown(element.name), row_, entries,
                            format_ == PlyFormat::ascii ? "its line" : "the file"));
  return std::size_t(entries);
}

void PlyRows::next_ascii(const PlyElement& element) {
  ++place_.line;
  std::string_view line = take_line(bytes_);
  const auto number = [&] {
    const auto value = number_in(take_word(line));
    if (!value)
      place_.fail(fmt::format("a value is missing or not a number; the header names {} per line",
                              element.properties.size()));
    return *value;
  };
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const double first = number();
    if (!element.properties[p].is_list) {
      values_.values[p] = first;
      continue;
    }
    values_.lists[p].resize(length(element, first, (line.size() + 1) / 2));
    for (double& entry : values_.lists[p]) entry = number();
  }
}

void PlyRows::next_binary(const PlyElement& element) {
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (!property.is_list) {
      values_.values[p] = binary(property.type);
      continue;
    }
    const double entries = binary(property.length);
    values_.lists[p].resize(length(element, entries, bytes_.size() / property.type.bytes));
    for (double& entry : values_.lists[p]) entry = binary(property.type);
  }
}

double PlyRows::binary(NumberType type) {
  if (bytes_.size() < type.bytes) place_.fail("the file ends inside an element; it is cut off");
  const double value = number_at(bytes_.data(), type, format_ == PlyFormat::big);
  bytes_.remove_prefix(type.bytes);
  return value;
}

}  // namespace freshet

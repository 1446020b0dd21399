// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdint>
#include <cstring>

#include "formats/point_sink.h"

namespace freshet {
namespace {

enum class Format { ascii, little, big };

struct Type {
  std::size_t bytes = 0;
  char kind = 0;  // 'i' signed, 'u' unsigned, 'f' floating
};

Type type_of(std::string_view name) {
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

struct Header {
  Format format = Format::ascii;
  std::uint64_t vertices = 0;
  std::vector<Type> types;
  std::size_t bytes_per_vertex = 0;
};

Format read_format(std::string_view words, const PointSink& sink) {
  const std::string_view name = take_word(words);
  if (name == "ascii") return Format::ascii;
  if (name == "binary_little_endian") return Format::little;
  if (name == "binary_big_endian") return Format::big;
  sink.fail("an unknown format; save it as ascii or binary_little_endian PLY");
}

std::uint64_t read_count(std::string_view word, const PointSink& sink) {
  const auto n = count_in(word);
  if (!n) sink.fail("the number of vertices is missing; save the file again");
  return *n;
}

/// Reads a comment: "comment time 0.5" is a note, other comments are ignored.
void read_comment(std::string_view words, PointSink& sink) {
  const std::string_view name = take_word(words);
  if (const auto value = number_in(trimmed(words))) sink.note(name, *value);
}

Header read_header(std::string_view& bytes, PointSink& sink) {
  Header h;
  bool has_format = false, in_vertex = false, has_vertex = false;
  sink.line = 1;
  if (trimmed(take_line(bytes)) != "ply")
    sink.fail("not PLY: the first line is not \"ply\"; check the file");
  while (!bytes.empty()) {
    std::string_view line = take_line(bytes);
    ++sink.line;
    const std::string_view key = take_word(line);
    if (key == "end_header") {
      if (!has_format || !has_vertex)
        sink.fail("the header has no format or no vertices; save the file again");
      sink.check();
      return h;
    }
    if (key == "comment") read_comment(line, sink);
    else if (key == "format") {
      h.format = read_format(line, sink);
      has_format = true;
    } else if (key == "element") {
      in_vertex = take_word(line) == "vertex";
      if (!in_vertex && !has_vertex)
        sink.fail("another element stands before the vertices; put them first");
      if (in_vertex) h.vertices = read_count(take_word(line), sink);
      has_vertex = true;
    } else if (key == "property" && in_vertex) {
      const Type type = type_of(take_word(line));
      if (type.bytes == 0)
        sink.fail("a vertex has a list or a property of unknown type; save it without");
      sink.name(std::string(take_word(line)), h.types.size());
      h.types.push_back(type);
      h.bytes_per_vertex += type.bytes;
    }
  }
  sink.fail("the header has no end; the file is cut off");
}

template <class T> double as(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return double(value);
}

double binary_number(const char* at, Type type, bool big) {
  unsigned char bytes[8];
  std::memcpy(bytes, at, type.bytes);
  if (big) std::reverse(bytes, bytes + type.bytes);
  if (type.kind == 'f') return type.bytes == 4 ? as<float>(bytes) : as<double>(bytes);
  const bool has_sign = type.kind == 'i';
  if (type.bytes == 1) return has_sign ? as<std::int8_t>(bytes) : as<std::uint8_t>(bytes);
  if (type.bytes == 2) return has_sign ? as<std::int16_t>(bytes) : as<std::uint16_t>(bytes);
  return has_sign ? as<std::int32_t>(bytes) : as<std::uint32_t>(bytes);
}

void read_ascii(std::string_view line, std::vector<double>& values, const PointSink& sink) {
  for (double& value : values) {
    const auto number = number_in(take_word(line));
    if (!number)
      sink.fail(fmt::format("not {} numbers, which the header asks for; the file is damaged",
                            values.size()));
    value = *number;
  }
}

}  // namespace

void read_ply(std::string_view bytes, PointSink& sink) {
  const Header h = read_header(bytes, sink);
  const bool ascii = h.format == Format::ascii;
  // an ascii number takes at least two characters; the last separator may be missing
  const std::size_t least = ascii ? 2 * h.types.size() : h.bytes_per_vertex;
  if (h.vertices > (bytes.size() + ascii) / least) {
    sink.line = 0;
    sink.fail(
        fmt::format("the header tells of {} vertices, and the file ends before; it is "
                    "cut off",
                    h.vertices));
  }
  std::vector<double> values(h.types.size());
  for (std::uint64_t k = 0; k < h.vertices; ++k) {
    if (ascii) {
      ++sink.line;
      read_ascii(take_line(bytes), values, sink);
    } else {
      sink.line = 0;
      for (std::size_t p = 0; p < values.size(); ++p) {
        values[p] = binary_number(bytes.data(), h.types[p], h.format == Format::big);
        bytes.remove_prefix(h.types[p].bytes);
      }
    }
    sink.add(values);
  }
}

}  // namespace freshet

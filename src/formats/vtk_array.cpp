// SPDX-License-Identifier: MIT
#include "formats/vtk_array.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstring>

#include "formats/numbers.h"

namespace freshet {
namespace {

constexpr std::uint64_t most_deflated = 1032;  // maximum expansion of a byte by deflate
constexpr std::size_t most_components = 1024;  // of a tuple; more are damaged files

/// The type of numbers by its name in VTK XML; of 0 bytes if it is unknown.
NumberType type_named(std::string_view name) {
  static constexpr struct {
    const char* name;
    NumberType type;
  } types[] = {{"Float32", {4, 'f'}}, {"Float64", {8, 'f'}}, {"Int8", {1, 'i'}},
               {"UInt8", {1, 'u'}},   {"Int16", {2, 'i'}},   {"UInt16", {2, 'u'}},
               {"Int32", {4, 'i'}},   {"UInt32", {4, 'u'}},  {"Int64", {8, 'i'}},
               {"UInt64", {8, 'u'}}};
  for (const auto& known : types)
    if (name == known.name) return known.type;
  return {};
}

/// Reads one array. Messages contain its name.
class ArrayReader {
 public:
  ArrayReader(const VtkArray& array, const VtkStorage& storage, PointSink& sink)
      : array_(array.node),
        name_(array.name),
        type_(type_named(array_.attribute("type").as_string())),
        storage_(storage),
        sink_(sink) {}

  std::vector<double> read(std::uint64_t count) const {
    const std::string_view format = array_.attribute("format").as_string("ascii");
    if (format == "ascii") return from_ascii(count);
    std::string decoded;
    const std::string_view bytes = stored(format, decoded);
    if (type_.bytes == 0) fail("its type is unknown; save it as Float32 or Float64");
    const std::string data = storage_.compressed ? inflated(bytes, count) : plain(bytes, count);
    return numbers_in(data, type_, storage_.big);
  }

 private:
  /// Fails at a line behind that of the DataArray element.
  [[noreturn]] void fail(const std::string& why, std::size_t lines_behind = 0) const {
    sink_.line =
        line_at(storage_.text, std::size_t(std::max<std::ptrdiff_t>(array_.offset_debug(), 0))) +
        lines_behind;
    sink_.fail(fmt::format("array \"{}\": {}", shown(name_), why));
  }
  [[noreturn]] void fail_short() const { fail("it ends too early; the file is cut off"); }

  std::vector<double> from_ascii(std::uint64_t count) const;
  std::string_view stored(std::string_view format, std::string& decoded) const;
  std::string from_base64(std::string_view text) const;
  std::uint64_t size_at(std::string_view bytes, std::uint64_t k) const;
  std::string plain(std::string_view bytes, std::uint64_t count) const;
  std::string inflated(std::string_view bytes, std::uint64_t count) const;
  std::string inflated_block(std::string_view bytes, std::uint64_t size) const;
  std::uint64_t bytes_of(std::uint64_t count) const { return count * type_.bytes; }

  const pugi::xml_node& array_;
  const std::string& name_;
  const NumberType type_;
  const VtkStorage& storage_;
  PointSink& sink_;
};

std::vector<double> ArrayReader::from_ascii(std::uint64_t count) const {
  const std::string_view text = array_.child_value();
  if (count > (text.size() + 1) / 2) fail_short();  // a number takes at least two characters
  std::string_view rest = text;
  std::vector<double> values = take_numbers(rest, count);
  const std::string_view read = text.substr(0, text.size() - rest.size());
  const std::size_t lines = std::size_t(std::count(read.begin(), read.end(), '\n'));
  if (rest.empty() && values.size() < count) fail_short();
  if (values.size() < count)
    fail(fmt::format("value {} is not a finite number; save the file again", values.size()), lines);
  if (!rest.empty())
    fail(fmt::format("more than the expected {} numbers; save the file again", count), lines);
  return values;
}

/// The stored bytes of an array, including the sizes before it. `decoded` holds them if they were
/// base64 text.
std::string_view ArrayReader::stored(std::string_view format, std::string& decoded) const {
  if (format == "binary") return decoded = from_base64(array_.child_value());
  if (format != "appended")
    fail("its format must be ascii, binary or appended; save the file again");
  const auto offset = count_in(array_.attribute("offset").as_string());
  if (!offset) fail("its offset is missing; save the file again");
  if (*offset > storage_.appended.size()) fail_short();
  const auto& offsets = storage_.offsets;
  const auto next = std::upper_bound(offsets.begin(), offsets.end(), *offset);
  const std::string_view bytes = storage_.appended.substr(
      *offset, next == offsets.end() ? std::string_view::npos : *next - *offset);
  return storage_.raw ? bytes : decoded = from_base64(bytes);
}

/// Decodes one or several streams of base64, each padded at its end.
std::string ArrayReader::from_base64(std::string_view text) const {
  const auto digit = [](char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  };
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int digits = 0, padding = 0;
  for (const char c : text) {
    if (std::strchr(white_space, c) && c) continue;
    const int value = c == '=' ? 0 : digit(c);
    if (value < 0 || (padding > 0 && c != '=')) fail("its data is not base64; save the file again");
    padding += c == '=';
    bits = bits << 6 | std::uint32_t(value);
    if (++digits < 4) continue;
    if (padding > 2) fail("its data is not base64; save the file again");
    for (int k = 0; k < 3 - padding; ++k) bytes += char(bits >> (16 - 8 * k) & 0xFF);
    bits = 0;
    digits = padding = 0;
  }
  if (digits > 0) fail_short();
  return bytes;
}

/// The k-th of the sizes that precede the array.
std::uint64_t ArrayReader::size_at(std::string_view bytes, std::uint64_t k) const {
  const std::size_t width = storage_.header_bytes;
  if (k >= bytes.size() / width) fail_short();
  char size[8] = {};
  std::memcpy(size, bytes.data() + k * width, width);
  if (storage_.big) std::reverse(size, size + width);
  std::uint64_t value;
  std::memcpy(&value, size, sizeof value);
  return value;
}

std::string ArrayReader::plain(std::string_view bytes, std::uint64_t count) const {
  const std::uint64_t size = size_at(bytes, 0);
  bytes.remove_prefix(storage_.header_bytes);
  if (size != bytes_of(count))
    fail(fmt::format("{} bytes instead of {}; save the file again", size, bytes_of(count)));
  if (size > bytes.size()) fail_short();
  return std::string(bytes.substr(0, size));
}

/// Inflates an array. Its header is the number of zlib blocks, the size of a block, the size of the
/// last block if it is smaller (else 0), and the compressed size of each block.
std::string ArrayReader::inflated(std::string_view bytes, std::uint64_t count) const {
  const std::uint64_t blocks = size_at(bytes, 0);
  if (blocks == 0 && count == 0) return {};
  const std::uint64_t block = size_at(bytes, 1), last = size_at(bytes, 2);
  if (blocks > bytes.size()) fail_short();
  std::string_view rest = bytes;
  rest.remove_prefix(std::min(rest.size(), (3 + blocks) * storage_.header_bytes));
  std::string all;
  for (std::uint64_t k = 0; k < blocks; ++k) {
    const std::uint64_t packed = size_at(bytes, 3 + k);
    if (packed > rest.size()) fail_short();
    all += inflated_block(rest.substr(0, packed), k + 1 == blocks && last > 0 ? last : block);
    rest.remove_prefix(packed);
    if (all.size() > bytes_of(count)) break;
  }
  if (all.size() != bytes_of(count))
    fail(fmt::format("{} bytes instead of {}; save the file again", all.size(), bytes_of(count)));
  return all;
}

std::string ArrayReader::inflated_block(std::string_view bytes, std::uint64_t size) const {
  if (size / most_deflated > bytes.size()) fail_short();
  std::string block(size, '\0');
  uLongf got = size;
  const int status = uncompress(reinterpret_cast<Bytef*>(block.data()), &got,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (status != Z_OK || got != size) fail("its zlib data is damaged; save the file again");
  return block;
}

}  // namespace

std::size_t components_of(const pugi::xml_node& array) {
  const auto count = count_in(array.attribute("NumberOfComponents").as_string("1"));
  return count && *count <= most_components ? std::size_t(*count) : 0;
}

std::vector<double> read_vtk_array(const VtkArray& array, std::uint64_t count,
                                   const VtkStorage& storage, PointSink& sink) {
  return ArrayReader(array, storage, sink).read(count);
}

}  // namespace freshet

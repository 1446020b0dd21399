// SPDX-License-Identifier: MIT
#include "formats/vtk_array.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cstring>

namespace freshet {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are copied as they stand");

constexpr const char* spaces = " \t\r\n";
constexpr std::uint64_t most_deflated = 1032;  // maximum expansion of a byte by deflate

/// Reads one array. Messages contain its name.
class ArrayReader {
 public:
  ArrayReader(const VtkArray& array, const VtkStorage& storage, const PointSink& sink)
      : array_(array.node), name_(array.name), storage_(storage), sink_(sink) {}

  std::vector<double> read(std::uint64_t count) const {
    const std::string_view format = array_.attribute("format").as_string("ascii");
    if (format == "ascii") return from_ascii(count);
    std::string decoded;
    const std::string_view bytes = stored(format, decoded);
    return numbers(storage_.compressed ? inflated(bytes, count) : plain(bytes, count), count);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    sink_.fail(fmt::format("array \"{}\": {}", name_, why));
  }
  [[noreturn]] void fail_short() const { fail("it ends too early; the file is cut off"); }

  std::vector<double> from_ascii(std::uint64_t count) const;
  std::string_view stored(std::string_view format, std::string& decoded) const;
  std::string from_base64(std::string_view text) const;
  std::uint64_t size_at(std::string_view bytes, std::uint64_t k) const;
  std::string plain(std::string_view bytes, std::uint64_t count) const;
  std::string inflated(std::string_view bytes, std::uint64_t count) const;
  std::string inflated_block(std::string_view bytes, std::uint64_t size) const;
  template <class T> std::vector<double> as(const std::string& bytes) const;
  std::vector<double> numbers(const std::string& bytes, std::uint64_t count) const;
  std::uint64_t bytes_of(std::uint64_t count) const;

  const pugi::xml_node& array_;
  const std::string& name_;
  const VtkStorage& storage_;
  const PointSink& sink_;
};

std::vector<double> ArrayReader::from_ascii(std::uint64_t count) const {
  std::string_view text = array_.child_value();
  if (count > (text.size() + 1) / 2) fail_short();  // a number takes at least two characters
  std::vector<double> values;
  for (std::string_view word; !(word = take_word(text, spaces)).empty();) {
    const auto value = number_in(word);
    if (!value) fail("a word in it is no number; save the file again");
    values.push_back(*value);
  }
  if (values.size() != count)
    fail(
        fmt::format("{} numbers, and there must be {}; save the file again", values.size(), count));
  return values;
}

/// The stored bytes of an array, including the sizes before it. `decoded` holds them if they were
/// base64 text.
std::string_view ArrayReader::stored(std::string_view format, std::string& decoded) const {
  if (format == "binary") return decoded = from_base64(array_.child_value());
  if (format != "appended")
    fail("its format is none of ascii, binary and appended; save the file again");
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
    if (std::strchr(spaces, c) && c) continue;
    const int value = c == '=' ? 0 : digit(c);
    if (value < 0 || (padding > 0 && c != '=')) fail("it is not base64; save the file again");
    padding += c == '=';
    bits = bits << 6 | std::uint32_t(value);
    if (++digits < 4) continue;
    if (padding > 2) fail("it is not base64; save the file again");
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
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data() + k * width, width);
  return size;
}

std::uint64_t ArrayReader::bytes_of(std::uint64_t count) const {
  const std::string_view type = array_.attribute("type").as_string();
  for (const int bits : {8, 16, 32, 64})
    if (type.ends_with(std::to_string(bits))) return count * std::uint64_t(bits) / 8;
  return 0;  // numbers() reports the unknown type
}

std::string ArrayReader::plain(std::string_view bytes, std::uint64_t count) const {
  const std::uint64_t size = size_at(bytes, 0);
  bytes.remove_prefix(storage_.header_bytes);
  if (size != bytes_of(count))
    fail(fmt::format("{} bytes, and there must be {}; save the file again", size, bytes_of(count)));
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
    fail(fmt::format("{} bytes, and there must be {}; save the file again", all.size(),
                     bytes_of(count)));
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

template <class T> std::vector<double> ArrayReader::as(const std::string& bytes) const {
  std::vector<double> values(bytes.size() / sizeof(T));
  for (std::size_t k = 0; k < values.size(); ++k) {
    T value;
    std::memcpy(&value, bytes.data() + k * sizeof value, sizeof value);
    values[k] = double(value);
  }
  return values;
}

std::vector<double> ArrayReader::numbers(const std::string& bytes, std::uint64_t count) const {
  const std::string_view type = array_.attribute("type").as_string();
  std::vector<double> values;
  if (type == "Float32") values = as<float>(bytes);
  else if (type == "Float64") values = as<double>(bytes);
  else if (type == "Int8") values = as<std::int8_t>(bytes);
  else if (type == "UInt8") values = as<std::uint8_t>(bytes);
  else if (type == "Int16") values = as<std::int16_t>(bytes);
  else if (type == "UInt16") values = as<std::uint16_t>(bytes);
  else if (type == "Int32") values = as<std::int32_t>(bytes);
  else if (type == "UInt32") values = as<std::uint32_t>(bytes);
  else if (type == "Int64") values = as<std::int64_t>(bytes);
  else if (type == "UInt64") values = as<std::uint64_t>(bytes);
  else fail("its type is unknown; save it as Float32 or Float64");
  if (values.size() != count) fail_short();
  return values;
}

}  // namespace

std::vector<double> read_vtk_array(const VtkArray& array, std::uint64_t count,
                                   const VtkStorage& storage, const PointSink& sink) {
  return ArrayReader(array, storage, sink).read(count);
}

}  // namespace freshet

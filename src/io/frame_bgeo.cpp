// SPDX-License-Identifier: MIT
#include <bit>
#include <limits>

#include "freshet/error.h"
#include "io/frame_data.h"

namespace freshet {
namespace {

enum class BgeoType : std::uint32_t { floats = 0, integers = 1, vectors = 5 };

/// A file in Houdini's classic format, version 5: big-endian words of 4 bytes.
class BgeoFile {
 public:
  BgeoFile(std::size_t points, std::size_t attributes) {
    if (points > std::size_t(std::numeric_limits<std::int32_t>::max()))
      throw Error(Error::Kind::run, "",
                  "too many particles for *.bgeo, which has numbers of 32 bits; choose another "
                  "`output.data`",
                  {"output.data"});
    bytes_ = "BgeoV";
    word(5);
    word(std::uint32_t(points));
    for (int k = 0; k < 3; ++k) word(0);  // primitives, point groups, primitive groups
    word(std::uint32_t(attributes));
    for (int k = 0; k < 3; ++k) word(0);  // attributes of vertices, of primitives, of the file
  }
  void attribute(std::string_view name, std::size_t size, BgeoType type) {
    half(std::uint16_t(name.size()));
    bytes_ += name;
    half(std::uint16_t(size));
    word(std::uint32_t(type));
    for (std::size_t k = 0; k < size; ++k) word(0);  // defaults
  }
  void word(std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes_ += char(value >> shift & 0xFF);
  }
  void number(float value) { word(std::bit_cast<std::uint32_t>(value)); }
  std::string finish() && {
    bytes_ += '\0';  // the end of the primitives
    bytes_ += '\xFF';
    return std::move(bytes_);
  }

 private:
  void half(std::uint16_t value) {
    bytes_ += char(value >> 8);
    bytes_ += char(value & 0xFF);
  }
  std::string bytes_;
};

std::uint32_t bgeo_id(std::uint64_t id) {
  if (id > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
    throw Error(Error::Kind::run, "",
                "an id needs more than 32 bits, which *.bgeo does not have; choose another "
                "`output.data`, or `output.fields` without \"id\"",
                {"output.data", "output.fields"});
  return std::uint32_t(id);
}

}  // namespace

std::string encode_bgeo(const PointTable& table) {
  BgeoFile file(table.size(), table.columns.size() + (table.pscale > 0));
  for (const PointColumn& column : table.columns)
    if (column.vectors) file.attribute("v", 3, BgeoType::vectors);
    else
      file.attribute(column.name, 1,
                     std::holds_alternative<const std::vector<float>*>(column.values)
                         ? BgeoType::floats
                         : BgeoType::integers);
  if (table.pscale > 0) file.attribute("pscale", 1, BgeoType::floats);
  const auto dimension = std::size_t(table.dimension);
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) file.number(k < dimension ? table.x[dimension * i + k] : 0);
    file.number(1);  // the weight of the position
    for (const PointColumn& column : table.columns)
      numbers_at(column, i, dimension, 3, [&](auto value) {
        if constexpr (std::is_same_v<decltype(value), float>) file.number(value);
        else if constexpr (std::is_same_v<decltype(value), std::uint64_t>)
          file.word(bgeo_id(value));
        else file.word(std::uint32_t(value));
      });
    if (table.pscale > 0) file.number(table.pscale);
  }
  return std::move(file).finish();
}

}  // namespace freshet

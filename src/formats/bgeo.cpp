// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <limits>

#include "formats/gzip_bytes.h"
#include "formats/numbers.h"
#include "formats/point_arrays.h"
#include "formats/point_formats.h"

namespace freshet {
namespace {

constexpr std::size_t word = 4;  // bytes of every number of a point
constexpr std::uint64_t most_attributes = 4096;
constexpr std::size_t position_words = 4;  // x, y, z and a weight
constexpr const char* damaged = "; the file is damaged";

/// An attribute of the points, and where a point holds it.
struct Attribute {
  std::size_t first_word;
  NumberType type;
};

/// Reads the header and the points; what follows in the file is not read.
class BgeoReader {
 public:
  BgeoReader(std::string_view bytes, PointSink& sink) : input_(bytes, sink), sink_(sink) {}

  void read() {
    check_magic();
    const std::uint64_t points = count("points");
    for (const char* skipped : {"primitives", "point groups", "primitive groups"}) count(skipped);
    const std::uint64_t attributes = count("point attributes");
    if (attributes > most_attributes)
      sink_.fail(fmt::format("{} point attributes; the maximum is {}, save fewer", attributes,
                             most_attributes));
    for (const char* skipped : {"vertex attributes", "primitive attributes", "attributes"})
      count(skipped);
    add_array("points", 3, {word, 'f'}, position_words);
    for (std::uint64_t k = 0; k < attributes; ++k) read_attribute();
    if (points > input_.most_left() / (word * words_))
      sink_.fail(fmt::format(
          "the header announces {} points, and the file is too short; it is cut off", points));
    const ArrayColumns columns(arrays_, sink_);
    for (std::uint64_t k = 0; k < points; ++k) read_point(columns);
    columns.add(arrays_, points);
  }

 private:
  std::uint64_t number(std::size_t bytes) {
    return std::uint64_t(number_at(input_.take(bytes).data(), {bytes, 'u'}, true));
  }
  std::uint64_t count(const char* what) {
    const std::uint64_t value = number(word);
    if (value > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
      sink_.fail(fmt::format("the number of {} is negative{}", what, damaged));
    return value;
  }
  std::string name() { return std::string(input_.take(number(2))); }

  void check_magic() {
    const std::string magic(input_.take(4));
    if (magic == "\x7FNSJ")
      sink_.fail(
          "this bgeo is of Houdini 12 or newer; in Houdini, save it as *.bhclassic or *.ply");
    if (magic != "Bgeo")
      sink_.fail("not a classic bgeo: it must begin with \"BgeoV\"; check the file");
    if (input_.take(1) != "V" || number(word) != 5)
      sink_.fail("this bgeo is not of version 5; in Houdini, save it as *.bhclassic or *.ply");
  }

  void add_array(std::string name, std::size_t components, NumberType type, std::size_t words) {
    arrays_.push_back({std::move(name), components});
    attributes_.push_back({words_, type});
    words_ += words;
  }

  void read_attribute() {
    enum Type { of_floats = 0, of_integers = 1, of_names = 4, of_vectors = 5 };
    std::string name = this->name();
    const auto size = std::size_t(number(2));
    const std::uint64_t type = number(word);
    if (type == of_names) {  // each is an index in a list of names
      for (std::uint64_t names = count("names"); names > 0; --names) this->name();
      return add_array(std::move(name), 0, {}, size);
    }
    if (type != of_floats && type != of_integers && type != of_vectors)
      sink_.fail(fmt::format("attribute \"{}\" has the unknown type {}; save the file without it",
                             shown(name), type));
    input_.take(size * word);  // defaults
    add_array(std::move(name), size, {word, type == of_integers ? 'i' : 'f'}, size);
  }

  void read_point(const ArrayColumns& columns) {
    const std::string_view point = input_.take(word * words_);
    for (std::size_t k = 0; k < arrays_.size(); ++k)
      for (std::size_t c = 0; columns.reads(k) && c < arrays_[k].components; ++c)
        arrays_[k].values.push_back(number_at(point.data() + word * (attributes_[k].first_word + c),
                                              attributes_[k].type, true));
  }

  InputBytes input_;
  PointSink& sink_;
  std::vector<PointArray> arrays_;
  std::vector<Attribute> attributes_;  // of the arrays
  std::size_t words_ = 0;              // of a point
};

}  // namespace

void read_bgeo(std::string_view bytes, PointSink& sink) { BgeoReader(bytes, sink).read(); }

}  // namespace freshet

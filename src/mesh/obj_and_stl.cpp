// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "formats/point_sink.h"
#include "mesh/mesh_formats.h"

namespace freshet {
namespace {

/// A coordinate; fails if the word is not one.
double coordinate(std::string_view word, const FilePlace& place) {
  const auto value = number_in(word);
  if (!value || !(std::abs(*value) <= farthest_corner))
    place.fail(
        fmt::format("a vertex has the coordinate \"{}\"; coordinates are finite numbers, at "
                    "most {:g}, export the mesh again",
                    word.substr(0, 40), farthest_corner));
  return *value;
}

class PlainObj {
 public:
  PlainObj(std::string_view bytes, FilePlace& place) : bytes_(bytes), place_(place) {}

  std::string write() {
    while (!bytes_.empty()) {
      std::string_view line = take_whole_line();
      const std::string_view key = take_word(line);
      if (key == "v") write_vertex(line);
      else if (key == "f") write_face(line);
    }
    if (greatest_ > vertices_) {
      place_.line = greatest_line_;
      fail_for_corner(greatest_);
    }
    place_.line = 0;
    if (faces_ == 0) place_.fail("the mesh has no faces; export it again");
    return fmt::to_string(out_);
  }

 private:
  /// A line, with those that follow a backslash at its end.
  std::string_view take_whole_line() {
    place_.line += 1 + std::exchange(joined_lines_, 0);
    std::string_view line = take_line(bytes_);
    if (!line.ends_with('\\')) return line;
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_ += line.substr(0, line.size() - 1);
      joined_ += ' ';
      line = take_line(bytes_);
      ++joined_lines_;
    }
    joined_ += line;
    return joined_;
  }

  void write_vertex(std::string_view line) {
    std::string_view words[4];
    int count = 0;
    for (std::string_view word; !(word = take_word(line)).empty(); ++count) {
      if (count < 4) words[count] = word;
      if (count < 3) coordinate(word, place_);
    }
    if (count < 3) place_.fail("a vertex has fewer than 3 coordinates; export the mesh again");
    if (count == 4 && coordinate(words[3], place_) == 0)
      place_.fail("a vertex has the weight 0, which is at infinity; export the mesh again");
    fmt::format_to(std::back_inserter(out_), "v {} {} {}{}{}\n", words[0], words[1], words[2],
                   count == 4 ? " " : "", count == 4 ? words[3] : "");
    if (++vertices_ > std::numeric_limits<int>::max())
      place_.fail("more than 2147483647 vertices; use a coarser mesh");
  }

  void write_face(std::string_view line) {
    out_.push_back('f');
    std::size_t corners = 0;
    for (std::string_view word; !(word = take_word(line)).empty(); ++corners) {
      if (corners == most_corners)
        place_.fail(
            fmt::format("a face has more than {} corners; split it into triangles", most_corners));
      fmt::format_to(std::back_inserter(out_), " {}", corner(word));
    }
    if (corners < 3)
      place_.fail(
          fmt::format("a face has {} corners; the minimum is 3, export the mesh again", corners));
    out_.push_back('\n');
    ++faces_;
  }

  /// The number of a vertex, from 1 on. "V/VT/VN" has it first; negative ones count back.
  std::int64_t corner(std::string_view word) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || (end != word.data() + word.size() && *end != '/'))
      place_.fail(fmt::format("a face has the vertex \"{}\"; write whole numbers like 7 or 7/1/1",
                              word.substr(0, 40)));
    if (index == 0 || index < -vertices_) fail_for_corner(index);
    if (index < 0) return vertices_ + index + 1;
    if (index > greatest_) {
      greatest_ = index;
      greatest_line_ = place_.line;
    }
    return index;
  }
  [[noreturn]] void fail_for_corner(std::int64_t index) const {
    place_.fail(
        fmt::format("a face has the vertex {}, and there are {} vertices, from 1 on; export "
                    "the mesh again",
                    index, vertices_));
  }

  std::string_view bytes_;
  FilePlace& place_;
  fmt::memory_buffer out_;
  std::string joined_;
  std::size_t joined_lines_ = 0, greatest_line_ = 0;
  std::int64_t vertices_ = 0, faces_ = 0, greatest_ = 0;
};

void check_ascii_stl(std::string_view bytes, const FilePlace& place) {
  if (bytes.find('\0') != std::string_view::npos)
    place.fail("it begins as ascii STL and has a zero byte; it is cut off or damaged");
  std::size_t facets = 0, vertices = 0;
  bool ended = false;
  const auto check_facet = [&] {
    if (vertices != 3 * facets)
      place.fail(
          fmt::format("facet {} must have 3 vertices; the file is cut off or damaged, export "
                      "the mesh again",
                      facets == 0 ? 0 : facets - 1));
  };
  for (std::string_view word; !(word = take_word(bytes, white_space)).empty();) {
    if (word == "solid" || word == "endsolid") {
      ended = word == "endsolid";
      take_line(bytes);  // its name
    } else if (word == "facet") {
      check_facet();
      ++facets;
    } else if (word == "vertex") {
      ++vertices;
      for (int k = 0; k < 3; ++k) coordinate(take_word(bytes, white_space), place);
    }
  }
  check_facet();
  if (facets == 0) place.fail("the mesh has no facets; export it again");
  if (!ended) place.fail("it ends without endsolid; it is cut off");
}

}  // namespace

std::string plain_obj(std::string_view bytes, FilePlace& place) {
  return PlainObj(bytes, place).write();
}

void check_stl(std::string_view bytes, FilePlace& place) {
  constexpr std::size_t head = 80, first = 84, facet = 50;  // bytes of a binary file
  const bool ascii = trimmed(bytes.substr(0, head)).starts_with("solid");
  std::uint32_t facets = 0;
  if (bytes.size() >= first) std::memcpy(&facets, bytes.data() + head, sizeof facets);
  const std::uint64_t whole = first + std::uint64_t(facets) * facet;
  if (bytes.size() == whole && facets == 0)
    place.fail("the mesh has no triangles; export it again");
  if (bytes.size() == whole) return;
  if (ascii) return check_ascii_stl(bytes, place);
  if (bytes.size() < first)
    place.fail(
        fmt::format("not STL: it does not begin with \"solid\", and {} "
                    "bytes are too few for binary STL; export the mesh again",
                    bytes.size()));
  place.fail(
      fmt::format("binary STL with {} triangles has {} bytes, and "
                  "this file has {}; it is cut off or damaged",
                  facets, whole, bytes.size()));
}

}  // namespace freshet

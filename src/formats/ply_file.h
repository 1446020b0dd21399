// SPDX-License-Identifier: MIT
/// The parts of a PLY file [Turk 1994] that files of points and meshes share.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/file_place.h"
#include "formats/numbers.h"

namespace freshet {

enum class PlyFormat { ascii, little, big };

struct PlyProperty {
  std::string name;
  NumberType type;  ///< of the value, or of the entries of a list
  bool is_list = false;
  NumberType length = {};  ///< of the length before a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
};

/// Calls while a header is read, so that errors have the line of their cause. Empty functions are
/// not called.
struct PlyEvents {
  std::function<void(std::string_view words)> comment = {};
  std::function<void(const PlyElement&)> element = {};  ///< its properties follow
  std::function<void(const PlyElement&, const PlyProperty&)> property = {};
};

/// Reads the header and removes it from `bytes`. Calls `place.fail` if it is not valid.
PlyHeader read_ply_header(std::string_view& bytes, FilePlace& place, const PlyEvents& events = {});

/// The values of a row, one entry per property.
struct PlyRow {
  std::vector<double> values;              ///< 0 for a list
  std::vector<std::vector<double>> lists;  ///< empty for a value
};

/// Reads the rows behind a header, in the order of its elements. It checks the size of the file
/// before it allocates memory.
class PlyRows {
 public:
  PlyRows(std::string_view bytes, PlyFormat format, FilePlace& place)
      : bytes_(bytes), format_(format), place_(place) {}

  /// Calls use(row, index) for each row of the element.
  template <class Use> void read(const PlyElement& element, Use use) {
    begin(element);
    for (row_ = 0; row_ < rows_of(element); ++row_) {
      next(element);
      use(static_cast<const PlyRow&>(values_), row_);
    }
  }
  void skip(const PlyElement& element) {
    read(element, [](const PlyRow&, std::uint64_t) {});
  }

 private:
  /// Binary rows without properties take no bytes.
  std::uint64_t rows_of(const PlyElement& element) const {
    return format_ != PlyFormat::ascii && element.properties.empty() ? 0 : element.count;
  }
  void begin(const PlyElement& element);
  void next(const PlyElement& element);
  double binary(NumberType type);
  std::size_t length(const PlyElement& element, double entries, std::size_t room) const;
  void next_ascii(const PlyElement& element);
  void next_binary(const PlyElement& element);

  std::string_view bytes_;
  PlyFormat format_;
  FilePlace& place_;
  PlyRow values_;
  std::uint64_t row_ = 0;
};

}  // namespace freshet

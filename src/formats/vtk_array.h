// SPDX-License-Identifier: MIT
/// The numbers of a DataArray of a VTK XML file.
#pragma once
#include <cstdint>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "formats/point_sink.h"

namespace freshet {

/// The storage of arrays in a VTK XML file.
struct VtkStorage {
  std::size_t header_bytes = 4;        ///< of a size before an array: 4 (UInt32) or 8 (UInt64)
  bool big = false;                    ///< numbers and sizes are in big-endian order
  bool compressed = false;             ///< by zlib, in blocks
  bool raw = false;                    ///< appended data are raw bytes, else base64
  std::string_view appended;           ///< appended data after the "_"; may be empty
  std::vector<std::uint64_t> offsets;  ///< of the arrays in the appended data, ascending
  std::string_view text;               ///< the elements, for the lines of messages
};

struct VtkArray {
  pugi::xml_node node;  ///< its DataArray
  std::string name;     ///< for messages
};

/// The number of components of each tuple.
std::size_t components_of(const pugi::xml_node& array);

/// Reads the `count` numbers of an array. Calls `sink.fail` at the line of the array if there are
/// fewer or more. It checks the size of the file before it allocates memory.
std::vector<double> read_vtk_array(const VtkArray& array, std::uint64_t count,
                                   const VtkStorage& storage, PointSink& sink);

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The numbers of a DataArray of a VTK XML file.
#pragma once
#include <cstdint>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "formats/point_sink.h"

namespace freshet {

/// How a VTK XML file stores its arrays.
struct VtkStorage {
  std::size_t header_bytes = 4;        ///< of the sizes before an array: 4 (UInt32) or 8 (UInt64)
  bool compressed = false;             ///< by zlib, in blocks
  bool raw = false;                    ///< the appended data: raw bytes, or base64
  std::string_view appended;           ///< what follows the "_"; empty if there is none
  std::vector<std::uint64_t> offsets;  ///< where arrays begin in it, ascending
};

struct VtkArray {
  pugi::xml_node node;  ///< its DataArray
  std::string name;     ///< what messages call it
};

/// The `count` numbers of an array. Throws by `sink.fail` where there are fewer or more, and before
/// anything is allocated that the file is too short for.
std::vector<double> read_vtk_array(const VtkArray& array, std::uint64_t count,
                                   const VtkStorage& storage, const PointSink& sink);

}  // namespace freshet

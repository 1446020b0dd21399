// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "surface/lattice.h"

namespace freshet {

/// A sparse grid of floats or of vectors of three floats. Its blocks are OpenVDB's leaf nodes.
struct VdbGrid {
  enum class Class { level_set, fog_volume, unknown };
  struct Block {
    Place place;
    const float* values[3];  ///< of each component, at the points of a block by point_index()
    /// A point is active where this is not 0; null: where a value is not ±background.
    const float* active = nullptr;
  };
  std::string name;
  Class kind = Class::unknown;
  int components = 1;    ///< 1 or 3
  float background = 0;  ///< value outside the blocks; points inside of a level set have its minus
  bool half = false;     ///< values are written as 16-bit floats
  float scale = 1;       ///< the file has the values times this
  std::vector<Block> blocks;
  std::vector<Place> inside;  ///< blocks that have the value -background everywhere
};

/// A file of OpenVDB, version 224, with mask compression. Point
/// (i, j, k) lies at origin + cell·(i, j, k) [m]. The same grids give the same bytes.
std::string encode_vdb(const std::vector<VdbGrid>& grids, const double (&origin)[3], double cell,
                       double time, std::int64_t step);

/// The bits of the 16-bit float nearest to a number; the largest one for larger numbers.
std::uint16_t half_float(float number);

}  // namespace freshet

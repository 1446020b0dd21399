// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "surface/kernels.h"

namespace freshet {

/// Σ_j volume_j w_j(x - x_j) at the grid points of the blocks near particles: 0 far from them,
/// about 1 deep in the fluid. Each value is one sum in the order of ParticleBins, so it does not
/// depend on threads.
class DensityField {
 public:
  using Values = std::array<float, block_points>;
  enum class Side : signed char { below, mixed, above };  ///< of a level, all values of a block

  DensityField(const ParticleBins& bins, const Kernels& kernels, const Threads& threads);

  int blocks() const { return int(keys_.size()); }
  Place place(int block) const { return place_of(keys_[std::size_t(block)]); }
  /// The block at a place, or -1: the field is 0 there, and at all points that touch it.
  int find(Place place) const;
  const Values& values(int block) const { return values_[std::size_t(block)]; }
  Side side(int block, float level) const;

 private:
  std::vector<std::uint64_t> keys_;  // ascending
  std::unordered_map<std::uint64_t, int> index_;
  std::vector<Values> values_;
  struct Range {
    float low, high;
  };
  std::vector<Range> range_;  // of the values of each block
};

}  // namespace freshet

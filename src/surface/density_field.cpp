// SPDX-License-Identifier: MIT
#include "surface/density_field.h"

#include <algorithm>
#include <cmath>

#include "surface/kernel_rows.h"

namespace freshet {
namespace {

/// The keys of all blocks with points within a support radius and a cell of a particle. The field
/// is 0 at all points of other blocks, and at the points beside these.
std::vector<std::uint64_t> blocks_near(const ParticleBins& bins) {
  const int reach = int(std::ceil(bins.support())) + 1;
  std::vector<std::uint64_t> keys;
  const auto low = [&](int x) { return floor_div(x - reach, block_cells); };
  const auto high = [&](int x) { return floor_div(x + bin_cells + reach, block_cells); };
  Place before{0, 0, 0};  // the bin before, whose row has its blocks up to `done`
  int done = 0;
  for (const ParticleBins::Bin& bin : bins.bins()) {
    const Place at = place_of(bin.key), corner = bin_cells * at;
    const bool same_row = !keys.empty() && at.y == before.y && at.z == before.z;
    const int first = same_row ? std::max(done + 1, low(corner.x)) : low(corner.x);
    for (int z = low(corner.z); z <= high(corner.z); ++z)
      for (int y = low(corner.y); y <= high(corner.y); ++y)
        for (int x = first; x <= high(corner.x); ++x) keys.push_back(key_of({x, y, z}));
    before = at;
    done = high(corner.x);
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

}  // namespace

DensityField::DensityField(const ParticleBins& bins, const Kernels& kernels, const Threads& threads)
    : keys_(blocks_near(bins)), values_(keys_.size()), range_(keys_.size()) {
  index_.reserve(keys_.size());
  for (std::size_t k = 0; k < keys_.size(); ++k) index_.emplace(keys_[k], int(k));
  constexpr int chunk = 16;
  const Spline spline(kernels.radius);
  threads.parts((blocks() + chunk - 1) / chunk, [&](int part) {
    Nearby nearby;
    for (int b = part * chunk; b < std::min(blocks(), (part + 1) * chunk); ++b) {
      Values& values = values_[std::size_t(b)];
      values.fill(0);
      bins.collect(block_bins * place(b), block_bins, nearby);
      for (std::size_t j = 0; j < nearby.size(); ++j) {
        const float volume = kernels.volume[std::size_t(nearby.particle[j])];
        for_each_weight(kernels, spline, nearby, j,
                        [&](std::size_t k, float w) { values[k] += volume * w; });
      }
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      range_[std::size_t(b)] = {*low, *high};
    }
  });
}

int DensityField::find(Place place) const {
  const auto found = index_.find(key_of(place));
  return found == index_.end() ? -1 : found->second;
}

DensityField::Side DensityField::side(int block, float level) const {
  if (block < 0) return Side::below;
  const Range& range = range_[std::size_t(block)];
  return range.low >= level ? Side::above : range.high < level ? Side::below : Side::mixed;
}

}  // namespace freshet

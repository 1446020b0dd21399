// SPDX-License-Identifier: MIT
#include "surface/particle_bins.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace freshet {

void Nearby::clear() {
  x.clear();
  y.clear();
  z.clear();
  particle.clear();
}

ParticleBins::ParticleBins(const std::vector<Point>& positions, float support) : support_(support) {
  const auto bin_of = [](double x) { return int(std::floor(x / bin_cells)); };
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(positions.size());
  for (const Point& x : positions)
    order.emplace_back(key_of({bin_of(x.x), bin_of(x.y), bin_of(x.z)}), int(order.size()));
  std::sort(order.begin(), order.end());
  frame_index_.reserve(order.size());
  offset_.reserve(order.size());
  for (const auto& [key, index] : order) {
    if (bins_.empty() || bins_.back().key != key)
      bins_.push_back({key, int(offset_.size()), int(offset_.size())});
    ++bins_.back().end;
    const Place bin = place_of(key);
    const Point x = positions[std::size_t(index)];
    offset_.push_back({float(x.x - bin_cells * bin.x), float(x.y - bin_cells * bin.y),
                       float(x.z - bin_cells * bin.z)});
    frame_index_.push_back(index);
  }
}

void ParticleBins::collect(Place low, int count, Nearby& out) const {
  out.clear();
  const int reach = int(std::ceil(support_ / bin_cells));
  const float size = float(count * bin_cells), support2 = support_ * support_;
  const auto beyond = [size](float x) { return std::max({-x, x - size, 0.0f}); };
  const auto earlier = [](const Bin& bin, std::uint64_t key) { return bin.key < key; };
  const int first = low.x - reach, last = low.x + count - 1 + reach;
  for (int z = low.z - reach; z < low.z + count + reach; ++z)
    for (int y = low.y - reach; y < low.y + count + reach; ++y) {
      const std::uint64_t end = key_of({last, y, z});
      for (auto bin = std::lower_bound(bins_.begin(), bins_.end(), key_of({first, y, z}), earlier);
           bin != bins_.end() && bin->key <= end; ++bin) {
        const Place corner = bin_cells * (place_of(bin->key) - low);
        for (int k = bin->first; k < bin->end; ++k) {
          const Vec<3, float> at = offset_[std::size_t(k)];
          const float px = float(corner.x) + at.x, py = float(corner.y) + at.y,
                      pz = float(corner.z) + at.z;
          const float dx = beyond(px), dy = beyond(py), dz = beyond(pz);
          if (dx * dx + dy * dy + dz * dz >= support2) continue;
          out.x.push_back(px);
          out.y.push_back(py);
          out.z.push_back(pz);
          out.particle.push_back(k);
        }
      }
    }
}

}  // namespace freshet

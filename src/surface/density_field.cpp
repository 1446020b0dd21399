// SPDX-License-Identifier: MIT
#include "surface/density_field.h"

#include <algorithm>
#include <cmath>

#include "surface/spline.h"

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

/// The points of a block along an axis that are closer to `at` than `radius`.
struct Points {
  int first, last;
  Points(float at, float radius)
      : first(std::max(0, int(std::ceil(at - radius)))),
        last(std::min(block_cells - 1, int(std::floor(at + radius)))) {}
};

/// Adds a particle to the points of a block, row by row.
void add_particle(DensityField::Values& values, Vec<3, float> at, float volume, Spline spline,
                  float support) {
  const float support2 = support * support;
  for (Points pz(at.z, support); pz.first <= pz.last; ++pz.first) {
    const float dz = float(pz.first) - at.z, left2 = support2 - dz * dz;
    if (left2 <= 0) continue;
    for (Points py(at.y, std::sqrt(left2)); py.first <= py.last; ++py.first) {
      const float dy = float(py.first) - at.y, yz2 = dz * dz + dy * dy;
      float* row = values.data() + point_index(0, py.first, pz.first);
      for (int x = 0; x < block_cells; ++x) {  // those beyond the support add 0
        const float dx = float(x) - at.x;
        row[x] += volume * spline(yz2 + dx * dx);
      }
    }
  }
}

/// Adds a particle whose kernel has a shape. Along a row, the squared distance in the round kernel
/// is a quadratic function; rows that it does not reach are skipped.
void add_shaped(DensityField::Values& values, Vec<3, float> at, float volume, Spline spline,
                float radius, const KernelShape& shape) {
  const float reach = radius * shape.reach, reach2 = reach * reach, radius2 = radius * radius;
  const Vec<3, float> along = shape.shrink * Vec<3, float>{1, 0, 0};
  const float a = norm2(along);
  for (Points pz(at.z, reach); pz.first <= pz.last; ++pz.first) {
    const float dz = float(pz.first) - at.z, left2 = reach2 - dz * dz;
    if (left2 <= 0) continue;
    for (Points py(at.y, std::sqrt(left2)); py.first <= py.last; ++py.first) {
      const Vec<3, float> start =
          shape.shrink * Vec<3, float>{-at.x, float(py.first) - at.y, dz};  // of x = 0
      const float b = dot(start, along), c = norm2(start);
      if (c * a - b * b >= radius2 * a) continue;
      float* row = values.data() + point_index(0, py.first, pz.first);
      for (int x = 0; x < block_cells; ++x) {
        const float fx = float(x);
        row[x] += volume * spline(std::max(c + fx * (2 * b + fx * a), 0.0f));
      }
    }
  }
}

/// The squared distance of a point from a block.
float distance2_of_block(Vec<3, float> at) {
  const auto beyond = [](float x) { return std::max({-x, x - float(block_cells), 0.0f}); };
  const Vec<3, float> d{beyond(at.x), beyond(at.y), beyond(at.z)};
  return norm2(d);
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
        const int particle = nearby.particle[j];
        const Vec<3, float> at{nearby.x[j], nearby.y[j], nearby.z[j]};
        const float volume = kernels.volume[std::size_t(particle)];
        if (kernels.is_round(particle)) add_particle(values, at, volume, spline, kernels.radius);
        else if (const float reach = kernels.reach(particle);
                 distance2_of_block(at) < reach * reach)
          add_shaped(values, at, volume, spline, kernels.radius,
                     kernels.shape[std::size_t(particle)]);
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

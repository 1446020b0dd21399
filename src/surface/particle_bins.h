// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "backend/cpu/threads.h"
#include "core/vec.h"
#include "surface/lattice.h"

namespace freshet {

/// Particles near a box of bins, in the order of their bins, then of the frame. Coordinates count
/// from the lower corner of the box [cells].
struct Nearby {
  std::vector<float> x, y, z;
  std::vector<int> particle;  ///< its place in ParticleBins
  std::size_t size() const { return particle.size(); }
  void clear();
};

/// Particles sorted by their bins, within a bin by their place in the frame. This order fixes the
/// order of all sums over particles.
class ParticleBins {
 public:
  using Point = Vec<3, double>;

  /// Positions are in cells, at most farthest_place bins from 0. `support` [cells] is the radius
  /// within which a particle counts.
  ParticleBins(const std::vector<Point>& positions, float support);

  struct Bin {
    std::uint64_t key;
    int first, end;  ///< its particles
  };
  const std::vector<Bin>& bins() const { return bins_; }
  std::size_t size() const { return frame_index_.size(); }
  float support() const { return support_; }
  int frame_index(int particle) const { return frame_index_[std::size_t(particle)]; }
  /// Position relative to the lower corner of the particle's bin.
  Vec<3, float> offset(int particle) const { return offset_[std::size_t(particle)]; }

  /// Collects the particles within the support radius of a box of `count`³ bins from `low` on.
  void collect(Place low, int count, Nearby& out) const;

 private:
  float support_;
  std::vector<Bin> bins_;
  std::vector<int> frame_index_;
  std::vector<Vec<3, float>> offset_;
};

/// Calls f(particle, the particles around its bin) for each particle, bin by bin.
template <class F> void for_each_particle(const ParticleBins& bins, const Threads& threads, F f) {
  constexpr int chunk = 64;
  const int n = int(bins.bins().size());
  threads.parts((n + chunk - 1) / chunk, [&](int part) {
    Nearby nearby;
    for (int b = part * chunk; b < std::min(n, (part + 1) * chunk); ++b) {
      const ParticleBins::Bin& bin = bins.bins()[std::size_t(b)];
      bins.collect(place_of(bin.key), 1, nearby);
      for (int k = bin.first; k < bin.end; ++k) f(k, nearby);
    }
  });
}

}  // namespace freshet

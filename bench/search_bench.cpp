// SPDX-License-Identifier: MIT
// The neighbour search and the pair passes of the reference backend over the number of particles:
// time per particle stays level with the grid, and grows with N for all pairs.
// Run: build/release/bin/freshet_bench
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "backend/reference/neighbor_lists.h"

namespace freshet {
namespace {

void search(benchmark::State& state, Search search, NeighborOrder order) {
  const int side = int(std::lround(std::sqrt(double(state.range(0)))));
  std::vector<Vec<2>> x;
  std::vector<std::uint64_t> id;
  for (int k = 0; k < side * side; ++k) {
    x.push_back({Real(k % side) + Real(0.01f) * Real(k % 7), Real(k / side)});
    id.push_back(std::uint64_t(k));
  }
  Particles<2> particles;
  particles.n = int(x.size());
  particles.x.data = x.data();
  particles.id.data = id.data();
  NeighborLists<2> lists;
  for (auto _ : state) lists.build(search, order, Real(2), particles, particles);
  state.counters["a particle"] =
      benchmark::Counter(double(state.iterations()) * double(particles.n),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK_CAPTURE(search, grid, Search::grid, NeighborOrder::cell)->Range(1 << 8, 1 << 18);
BENCHMARK_CAPTURE(search, grid_by_id, Search::grid, NeighborOrder::id)->Range(1 << 8, 1 << 18);
BENCHMARK_CAPTURE(search, all_pairs, Search::all_pairs, NeighborOrder::id)->Range(1 << 8, 1 << 12);

}  // namespace
}  // namespace freshet

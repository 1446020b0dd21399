// SPDX-License-Identifier: MIT
// Time of the neighbour searches over the number of particles N: the time per particle is constant
// for the grids and grows with N for all pairs. A KD-tree is compared. One thread each.
// Run: build/release/bin/freshet_bench
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "backend/reference/neighbor_lists.h"
#if defined(FRESHET_NANOFLANN)
#include "backend/kd_tree.h"
#endif

namespace freshet {
namespace {

constexpr Real h = 2;  // spacings

/// About n particles on a slightly sheared lattice of spacing 1, in the order of its rows.
template <int D> struct Lattice {
  std::vector<Vec<D>> x;
  std::vector<std::uint64_t> id;

  explicit Lattice(const benchmark::State& state) {
    const int side = int(std::lround(std::pow(double(state.range(0)), 1.0 / D)));
    for (int k = 0; k < (D == 3 ? side * side * side : side * side); ++k) {
      Vec<D> at;
      for (int d = 0, part = k; d < D; ++d, part /= side) component(at, d) = Real(part % side);
      at.x += Real(0.01f) * Real(k % 7);
      x.push_back(at);
      id.push_back(std::uint64_t(k));
    }
  }
  int n() const { return int(x.size()); }
  Particles<D> particles() {
    Particles<D> p;
    p.n = n();
    p.x.data = x.data();
    p.id.data = id.data();
    return p;
  }
};

void count(benchmark::State& state, int n) {
  state.counters["a particle"] = benchmark::Counter(
      double(state.iterations()) * n, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <int D, Search how, NeighborOrder order> void search(benchmark::State& state) {
  Lattice<D> lattice(state);
  const Particles<D> particles = lattice.particles();
  NeighborLists<D> lists;
  for (auto _ : state) lists.build(how, order, h, particles, particles);
  count(state, lattice.n());
}

/// Sorts the particles and lists their neighbours.
template <int D> void cpu_backend(benchmark::State& state) {
  const Lattice<D> lattice(state);
  CpuBackend<D> backend(1);
  Particles<D> particles;
  backend.add_set(particles, lattice.n());
  backend.allocate(particles, Keep::kept, particles.x);
  backend.allocate(particles, Keep::kept, particles.id);
  for (int i = 0; i < lattice.n(); ++i) {
    particles.x[i] = lattice.x[i];
    particles.id[i] = lattice.id[i];
  }
  for (auto _ : state) backend.find_neighbors("neighbors", h, particles);
  count(state, lattice.n());
}

void sizes_of_scenes(benchmark::internal::Benchmark* b) { b->Arg(10'000)->Arg(100'000); }

BENCHMARK(search<2, Search::grid, NeighborOrder::cell>)
    ->Name("grid<2>")
    ->Range(1 << 8, 1 << 18)
    ->Apply(sizes_of_scenes);
BENCHMARK(search<3, Search::grid, NeighborOrder::cell>)->Name("grid<3>")->Apply(sizes_of_scenes);
BENCHMARK(search<2, Search::grid, NeighborOrder::id>)
    ->Name("grid_by_id<2>")
    ->Range(1 << 8, 1 << 18);
BENCHMARK(search<2, Search::all_pairs, NeighborOrder::id>)
    ->Name("all_pairs<2>")
    ->Range(1 << 8, 1 << 12);
BENCHMARK(cpu_backend<2>)->Apply(sizes_of_scenes);
BENCHMARK(cpu_backend<3>)->Apply(sizes_of_scenes);

#if defined(FRESHET_NANOFLANN)
/// Builds the tree, then writes the neighbours of every particle to one array.
template <int D, bool with_queries> void kd_tree(benchmark::State& state) {
  Lattice<D> lattice(state);
  const Particles<D> particles = lattice.particles();
  std::vector<int> list;
  for (auto _ : state) {
    const KdTree<D> tree(particles);
    list.clear();
    if (with_queries)
      for (int i = 0; i < lattice.n(); ++i) tree.find(particles.x[i], h * h, list);
    benchmark::DoNotOptimize(&tree);
    benchmark::DoNotOptimize(list.data());
    benchmark::ClobberMemory();
  }
  count(state, lattice.n());
}
BENCHMARK(kd_tree<2, true>)->Name("kd_tree<2>")->Apply(sizes_of_scenes);
BENCHMARK(kd_tree<3, true>)->Name("kd_tree<3>")->Apply(sizes_of_scenes);
BENCHMARK(kd_tree<2, false>)->Name("kd_tree<2>/build")->Apply(sizes_of_scenes);
BENCHMARK(kd_tree<3, false>)->Name("kd_tree<3>/build")->Apply(sizes_of_scenes);
#endif

}  // namespace
}  // namespace freshet

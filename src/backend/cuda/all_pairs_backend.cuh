// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>

#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <class F> __global__ void visit_all(F f, int n) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) f(i);
}

/// Adds the term over all j of its set, also distant ones: kernels are zero beyond their support.
template <int D, class Term, class Sum>
__device__ void add_over_all(const Over<D, Term>& over, Vec<D> x_i, int i, Sum& sum) {
  const auto at_i = over.term.at(i);
  for (int j = 0; j < over.set.n; ++j)
    sum += over.term(Pair<D, Real>(x_i - over.set.x[j]), at_i, over.term.neighbor(j));
}

template <int D, class Sum, class Finish, class... Terms>
__global__ void sum_over_all(Particles<D> targets, Finish finish, Sum* sums,
                             Over<D, Terms>... overs) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i >= targets.n) return;
  Sum sum{};
  (add_over_all(overs, targets.x[i], i, sum), ...);
  sums[i] = sum;  // finish_all runs after all sums, which see the fields before the pass
}
template <class Sum, class Finish>
__global__ void finish_all(Finish finish, const Sum* sums, int n) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) finish(i, sums[i]);
}

template <class Map> __global__ void map_all(Map map, double* values, int n) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) values[i] = double(map(i));
}

/// A minimal backend for compiling device code: one thread per particle, all particles are
/// candidates, no copies. It proves that solvers, pair terms and kernels are device code. No
/// simulation runs on it.
template <int D> class AllPairsBackend {
 public:
  template <class... Fixed>
  void find_neighbors(const char*, Real, Particles<D>&, const Fixed&...) {}
  void list_neighbors(const char*, Real, const Particles<D>&, const Particles<D>&) {}
  template <class... Fields> void share(const char*, const Particles<D>&, Fields...) {}

  template <class... Args>
  void sum_pairs(const char*, const Particles<D>& targets, const Args&... sources_finish) {
    with_last_first(
        [&](const auto& finish, const auto& first, const auto&... more) {
          using Sum = typename std::decay_t<decltype(first)>::template Sum<Real>;
          auto* sums = static_cast<Sum*>(memory(sizeof(Sum) * std::size_t(targets.n)));
          sum_over_all<<<blocks(targets.n), threads>>>(targets, finish, sums, first, more...);
          finish_all<<<blocks(targets.n), threads>>>(finish, sums, targets.n);
        },
        sources_finish...);
  }
  template <class Visit> void for_each(const char*, const Particles<D>& p, const Visit& visit) {
    visit_all<<<blocks(p.n), threads>>>(visit, p.n);
  }
  template <class Map> double max(const char*, const Particles<D>& p, const Map& map) {
    const double* values = mapped(p, map);
    double most = values[0];
    for (int i = 1; i < p.n; ++i) most = values[i] > most ? values[i] : most;
    return most;
  }
  template <class Map> double sum(const char*, const Particles<D>& p, const Map& map) {
    const double* values = mapped(p, map);
    double total = 0;
    for (int i = 0; i < p.n; ++i) total += values[i];
    return total;
  }
  template <class Map, class Sum>
  void sum_groups(const char*, const Particles<D>& p, int groups, const Map& map, Sum* sums) {
    cudaDeviceSynchronize();
    for (int g = 0; g < groups; ++g) sums[g] = Sum{};
    for (int i = 0; i < p.n; ++i) {
      const auto item = map(i);
      for (int c = 0; c < Sum::size; ++c) sums[item.group][c] += item.value[c];
    }
  }

 private:
  static constexpr int threads = 128;
  static int blocks(int n) { return (n + threads - 1) / threads; }
  template <class Map> const double* mapped(const Particles<D>& p, const Map& map) {
    auto* values = static_cast<double*>(memory(sizeof(double) * std::size_t(p.n)));
    map_all<<<blocks(p.n), threads>>>(map, values, p.n);
    cudaDeviceSynchronize();
    return values;
  }
  void* memory(std::size_t bytes) {
    cudaFree(memory_);
    if (cudaMallocManaged(&memory_, bytes) != cudaSuccess) throw std::bad_alloc();
    return memory_;
  }
  void* memory_ = nullptr;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

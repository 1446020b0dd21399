// SPDX-License-Identifier: MIT
// Cost of a kernel in the cpu backend's loop over neighbours: a pass of densities and a pass of
// gradients. One thread; the support is two spacings, as in search_bench.cpp.
// Run: build/release/bin/freshet_bench --benchmark_filter=pass
#include <benchmark/benchmark.h>

#include <random>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "kernels/cubic_spline.h"
#include "kernels/poly6.h"
#include "kernels/spiky.h"
#include "kernels/wendland.h"
#include "pairs/density.h"

namespace freshet {
namespace {

template <int D, template <int> class Kernel> struct Gradient {
  Kernel<D> W;
  template <class R> using At = Nothing<R>;
  template <class R> using Neighbor = Nothing<R>;
  At<Real> at(int) const { return {}; }
  Neighbor<Real> neighbor(int) const { return {}; }
  template <class R> FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, At<R>, At<R>) const {
    return W.gradient(ij);
  }
};

template <int D, class Term, class Value> void pass(benchmark::State& state, const Term& term) {
  CpuBackend<D> backend(1);
  Particles<D> p;
  Field<Value> sums;
  const int side = D == 3 ? 46 : 316, n = D == 3 ? side * side * side : side * side;
  backend.add_set(p, n);
  backend.allocate(p, Keep::kept, p.x);
  backend.allocate(p, Keep::kept, p.id);
  backend.allocate(p, Keep::scratch, sums);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  for (int k = 0; k < n; ++k) {
    p.id[k] = std::uint64_t(k);
    for (int d = 0, part = k; d < D; ++d, part /= side)
      component(p.x[k], d) = Real(part % side + jitter(generator));
  }
  backend.find_neighbors("neighbors", Real(2), p);
  for (auto _ : state)
    backend.sum_pairs("pass", p, over(p, term), [=](int i, const Value& sum) { sums[i] = sum; });
  state.counters["a particle"] = benchmark::Counter(
      double(state.iterations()) * n, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <int D, template <int> class Kernel> void density(benchmark::State& state) {
  pass<D, Density<D, Kernel>, Real>(state, {Kernel<D>(Real(2)), Real(1)});
}
template <int D, template <int> class Kernel> void gradient(benchmark::State& state) {
  pass<D, Gradient<D, Kernel>, Vec<D>>(state, {Kernel<D>(Real(2))});
}

#define FRESHET_PASS(what, Kernel)                                    \
  BENCHMARK(what<2, Kernel>)->Name("pass/" #what "<2, " #Kernel ">"); \
  BENCHMARK(what<3, Kernel>)->Name("pass/" #what "<3, " #Kernel ">")
FRESHET_PASS(density, Poly6);
FRESHET_PASS(density, CubicSpline);
FRESHET_PASS(density, WendlandC2);
FRESHET_PASS(density, WendlandC4);
FRESHET_PASS(density, WendlandC6);
FRESHET_PASS(gradient, Spiky);
FRESHET_PASS(gradient, CubicSpline);
FRESHET_PASS(gradient, WendlandC2);
FRESHET_PASS(gradient, WendlandC4);
FRESHET_PASS(gradient, WendlandC6);
#undef FRESHET_PASS

}  // namespace
}  // namespace freshet

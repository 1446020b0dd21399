// SPDX-License-Identifier: MIT
// Time per particle of the cpu backend's neighbour search (sort and lists) and of a density pass,
// in blocks whose particles move a little between searches. The fastest round counts.
// Run: build/release/bin/freshet_cpu_search_bench [threads ...]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "backend/cpu/cpu_backend.h"
#include "backend/cpu/cpu_sets_impl.h"
#include "kernels/poly6.h"
#include "pairs/density.h"

namespace freshet {
inline namespace FRESHET_ISA {
namespace {

/// A block of side^D particles of spacing 1; each is displaced by up to 0.2 along each axis.
template <int D> void measure(int side, double support, int threads, int rounds) {
  CpuBackend<D> backend(threads);
  Particles<D> p;
  Field<Real> rho;
  int n = 1;
  for (int d = 0; d < D; ++d) n *= side;
  backend.add_set(p, n);
  backend.allocate(p, Keep::kept, p.id);
  backend.allocate(p, Keep::kept, p.x);
  backend.allocate(p, Keep::kept, p.v);
  backend.allocate(p, Keep::scratch, rho);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2), speed(-0.04, 0.04);
  for (int i = 0; i < n; ++i) {
    p.id[i] = std::uint64_t(i);
    for (int d = 0, k = i; d < D; ++d, k /= side) {
      component(p.x[i], d) = Real(k % side + jitter(generator));
      component(p.v[i], d) = Real(speed(generator));
    }
  }
  const Density density{Poly6<D>(Real(support)), Real(1)};
  const auto density_of = rho;
  using Clock = std::chrono::steady_clock;
  const auto since = [&](Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / n;
  };
  double search = 1e9, pass = 1e9;
  for (int round = 0; round < rounds; ++round) {
    backend.for_each("move", p,
                     [=](int i) { p.x[i] = round % 2 ? p.x[i] - p.v[i] : p.x[i] + p.v[i]; });
    auto start = Clock::now();
    backend.find_neighbors("neighbors", Real(support), p);
    if (round > 0) search = std::min(search, since(start));
    start = Clock::now();
    backend.sum_pairs("density", p, over(p, density), [=](int i, Real s) { density_of[i] = s; });
    pass = std::min(pass, since(start));
  }
  std::printf("%dD %8d particles, support %.3f, %d threads: neighbors %6.1f ns, density %5.1f ns\n",
              D, n, support, threads, search, pass);
}

}  // namespace
}  // namespace FRESHET_ISA
}  // namespace freshet

int main(int argc, char** argv) {
  for (int k = 1; k < std::max(argc, 2); ++k) {
    const int threads = argc > 1 ? std::atoi(argv[k]) : 2;
    freshet::measure<3>(100, 2.154, threads, 12);
    freshet::measure<3>(100, 2.0, threads, 12);
    freshet::measure<2>(1000, 2.5, threads, 12);
    freshet::measure<2>(1000, 2.0, threads, 12);
  }
}

// SPDX-License-Identifier: MIT
// Time to make the surface of a cube of particles, without files.
// Run: build/release/bin/freshet_surface_bench
#include <benchmark/benchmark.h>

#include <cmath>

#include "freshet/surface.h"

namespace freshet {
namespace {

void make_surface(benchmark::State& state) {
  const int side = int(std::round(std::cbrt(double(state.range(0)))));
  Frame frame;
  frame.dimension = 3;
  for (int k = 0; k < side * side * side; ++k) {
    const int place[] = {k % side, k / side % side, k / side / side};
    for (int axis = 0; axis < 3; ++axis)  // off the lattice, as in a flow
      frame.x.push_back(float(place[axis]) + 0.1f * std::sin(float(7 * k + axis)));
    frame.id.push_back(std::uint64_t(k));
  }
  frame.v = frame.x;
  std::size_t triangles = 0;
  for (auto _ : state)
    triangles = surface_of(frame, 1, {0, 0, 0}, {}, int(state.range(1))).triangles.size();
  state.counters["triangles"] = double(triangles);
}

BENCHMARK(make_surface)
    ->Name("surface")
    ->ArgNames({"particles", "threads"})
    ->Args({100'000, 1})
    ->Args({100'000, 2})
    ->Args({1'000'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace freshet

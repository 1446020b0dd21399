// SPDX-License-Identifier: MIT
// Time to draw a picture of 1920 × 1080 pixels of a million particles.
// Run: build/release/bin/freshet_picture_bench
#include <benchmark/benchmark.h>

#include <cmath>

#include "render/draw.h"
#include "render/png.h"

namespace freshet {
namespace {

/// Water with a wavy surface fills the left half of a tank.
template <int D> void draw_water(benchmark::State& state) {
  const std::int64_t n = state.range(0);
  const int threads = int(state.range(1)), side = int(std::round(std::pow(double(n), 1.0 / D)));
  Scene scene;
  scene.domain.min.assign(D, 0);
  scene.domain.max.assign(D, 1);
  scene.domain.max[0] = 2;
  scene.particles.spacing = 1.0 / side;
  scene.fluid.emplace_back();
  scene.time.end = 1;
  scene.picture.width = 1920;
  scene.picture.height = 1080;
  Frame frame;
  frame.dimension = D;
  for (int k = 0; k < int(std::pow(side, D)); ++k) {
    const float x = (float(k % side) + 0.5f) / float(side);
    const float y = (float(k / side % side) + 0.5f) / float(side) * (0.8f + 0.2f * std::sin(9 * x));
    frame.x.insert(frame.x.end(), {x, y});
    if (D == 3) frame.x.push_back((float(k / side / side) + 0.5f) / float(side));
    frame.id.push_back(std::uint64_t(k));
  }
  for (std::size_t k = 0; k < frame.x.size(); ++k) frame.v.push_back(frame.x[k]);
  frame.density.assign(frame.id.size(), 1000);
  frame.pressure.assign(frame.id.size(), 0);
  for (auto _ : state) {
    const Image image = draw(scene, frame, {}, threads);
    benchmark::DoNotOptimize(image.pixels.data());
  }
}

BENCHMARK(draw_water<3>)
    ->Name("picture/3d")
    ->ArgNames({"particles", "threads"})
    ->Args({100'000, 1})
    ->Args({1'000'000, 1})
    ->Args({1'000'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(draw_water<2>)
    ->Name("picture/2d")
    ->ArgNames({"particles", "threads"})
    ->Args({1'000'000, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace freshet

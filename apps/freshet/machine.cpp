// SPDX-License-Identifier: MIT
#include "machine.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace freshet::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr int rounds = 2000000, vectors = 10;

/// Independent chains of a = a*b + c in ten vectors of eight; where the machine has FMA, fused.
#if defined(__x86_64__)
__attribute__((target("avx2,fma"))) float fused_chains() {
  __m256 a[vectors], b = _mm256_set1_ps(0.999f), c = _mm256_set1_ps(0.001f);
  for (__m256& v : a) v = _mm256_set1_ps(0.5f);
  for (int k = 0; k < rounds; ++k)
    for (__m256& v : a) v = _mm256_fmadd_ps(v, b, c);
  float sum = 0;
  for (const __m256& v : a) sum += _mm256_cvtss_f32(v);
  return sum;
}
#endif

float plain_chains() {
  float a[8 * vectors], sum = 0;
  std::fill_n(a, 8 * vectors, 0.5f);
  for (int k = 0; k < rounds; ++k)
    for (float& lane : a) lane = lane * 0.999f + 0.001f;
  for (const float lane : a) sum += lane;
  return sum;
}

float chains() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return fused_chains();
#endif
  return plain_chains();
}

}  // namespace

Ceilings measure_ceilings() {
  Ceilings best{0, 0};
  constexpr std::size_t n = 8u << 20;
  std::vector<float> a(n), b(n, 1), c(n, 2);
  volatile float sink = 0;
  for (int repeat = 0; repeat < 3; ++repeat) {
    auto start = Clock::now();
    sink = chains();
    best.flops = std::max(best.flops, 16.0 * vectors * rounds / seconds_since(start));
    start = Clock::now();
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 0.5f * c[i];
    best.bytes_per_second =
        std::max(best.bytes_per_second, 12.0 * double(n) / seconds_since(start));
    sink = a[n / 2];
  }
  static_cast<void>(sink);
  return best;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);
}

}  // namespace freshet::cli

// SPDX-License-Identifier: MIT
/// A pack of lanes, one particle per lane. It is the number type of pair terms in this backend.
/// Code for instruction sets is in this file, in records.h and in append.h only.
#pragma once
#include <cstring>

#include "core/vec.h"

#if defined(FRESHET_DOUBLE) || !defined(__SSE4_2__)
#define FRESHET_PLAIN_LANES
#else
#include <immintrin.h>
#endif

namespace freshet {
inline namespace FRESHET_ISA {

#if defined(FRESHET_PLAIN_LANES)
inline constexpr int lanes = 4;
#elif defined(__AVX512F__)
inline constexpr int lanes = 16;
#elif defined(__AVX2__)
inline constexpr int lanes = 8;
#else
inline constexpr int lanes = 4;
#endif

#if defined(FRESHET_PLAIN_LANES)

struct Mask {
  bool v[lanes];
};
struct Pack {
  Real v[lanes];
  Pack() = default;  // trivial: Pack{} is zero
  FRESHET_HD Pack(Real a) {
    for (Real& lane : v) lane = a;
  }
};
#define FRESHET_LANES(result, expression)              \
  result r;                                            \
  for (int l = 0; l < lanes; ++l) r.v[l] = expression; \
  return r
FRESHET_HD Pack operator+(Pack a, Pack b) { FRESHET_LANES(Pack, a.v[l] + b.v[l]); }
FRESHET_HD Pack operator-(Pack a, Pack b) { FRESHET_LANES(Pack, a.v[l] - b.v[l]); }
FRESHET_HD Pack operator*(Pack a, Pack b) { FRESHET_LANES(Pack, a.v[l] * b.v[l]); }
FRESHET_HD Pack operator/(Pack a, Pack b) { FRESHET_LANES(Pack, a.v[l] / b.v[l]); }
FRESHET_HD Pack operator-(Pack a) { FRESHET_LANES(Pack, -a.v[l]); }
FRESHET_HD Mask operator<(Pack a, Pack b) { FRESHET_LANES(Mask, a.v[l] < b.v[l]); }
FRESHET_HD Pack select(Mask m, Pack a, Pack b) { FRESHET_LANES(Pack, m.v[l] ? a.v[l] : b.v[l]); }
FRESHET_HD Pack sqrt(Pack a) { FRESHET_LANES(Pack, sqrt(a.v[l])); }
FRESHET_HD Pack max(Pack a, Pack b) { FRESHET_LANES(Pack, max(a.v[l], b.v[l])); }
FRESHET_HD Pack min(Pack a, Pack b) { FRESHET_LANES(Pack, min(a.v[l], b.v[l])); }
#undef FRESHET_LANES
FRESHET_HD unsigned bits(Mask m) {
  unsigned b = 0;
  for (int l = 0; l < lanes; ++l) b |= unsigned(m.v[l]) << l;
  return b;
}

#else

typedef float Floats __attribute__((vector_size(4 * lanes)));

struct Pack {
  Floats v;
  Pack() = default;  // trivial: Pack{} is zero
  FRESHET_HD Pack(Floats a) : v(a) {}
  FRESHET_HD Pack(float a) : v(a - Floats{}) {}
};
FRESHET_HD Pack operator+(Pack a, Pack b) { return a.v + b.v; }
FRESHET_HD Pack operator-(Pack a, Pack b) { return a.v - b.v; }
FRESHET_HD Pack operator*(Pack a, Pack b) { return a.v * b.v; }
FRESHET_HD Pack operator/(Pack a, Pack b) { return a.v / b.v; }
FRESHET_HD Pack operator-(Pack a) { return -a.v; }

#if defined(__AVX512F__)
struct Mask {
  __mmask16 m;
};
FRESHET_HD Mask operator<(Pack a, Pack b) {
  return {_mm512_cmp_ps_mask(__m512(a.v), __m512(b.v), _CMP_LT_OQ)};
}
FRESHET_HD Pack select(Mask m, Pack a, Pack b) {
  return Floats(_mm512_mask_blend_ps(m.m, __m512(b.v), __m512(a.v)));
}
FRESHET_HD Pack sqrt(Pack a) { return Floats(_mm512_sqrt_ps(__m512(a.v))); }
FRESHET_HD Pack max(Pack a, Pack b) { return Floats(_mm512_max_ps(__m512(a.v), __m512(b.v))); }
FRESHET_HD Pack min(Pack a, Pack b) { return Floats(_mm512_min_ps(__m512(a.v), __m512(b.v))); }
FRESHET_HD unsigned bits(Mask m) { return m.m; }
#elif defined(__AVX2__)
struct Mask {
  __m256 m;
};
FRESHET_HD Mask operator<(Pack a, Pack b) {
  return {_mm256_cmp_ps(__m256(a.v), __m256(b.v), _CMP_LT_OQ)};
}
FRESHET_HD Pack select(Mask m, Pack a, Pack b) {
  return Floats(_mm256_blendv_ps(__m256(b.v), __m256(a.v), m.m));
}
FRESHET_HD Pack sqrt(Pack a) { return Floats(_mm256_sqrt_ps(__m256(a.v))); }
FRESHET_HD Pack max(Pack a, Pack b) { return Floats(_mm256_max_ps(__m256(a.v), __m256(b.v))); }
FRESHET_HD Pack min(Pack a, Pack b) { return Floats(_mm256_min_ps(__m256(a.v), __m256(b.v))); }
FRESHET_HD unsigned bits(Mask m) { return unsigned(_mm256_movemask_ps(m.m)); }
#else
struct Mask {
  __m128 m;
};
FRESHET_HD Mask operator<(Pack a, Pack b) { return {_mm_cmplt_ps(__m128(a.v), __m128(b.v))}; }
FRESHET_HD Pack select(Mask m, Pack a, Pack b) {
  return Floats(_mm_blendv_ps(__m128(b.v), __m128(a.v), m.m));
}
FRESHET_HD Pack sqrt(Pack a) { return Floats(_mm_sqrt_ps(__m128(a.v))); }
FRESHET_HD Pack max(Pack a, Pack b) { return Floats(_mm_max_ps(__m128(a.v), __m128(b.v))); }
FRESHET_HD Pack min(Pack a, Pack b) { return Floats(_mm_min_ps(__m128(a.v), __m128(b.v))); }
FRESHET_HD unsigned bits(Mask m) { return unsigned(_mm_movemask_ps(m.m)); }
#endif
#endif

FRESHET_HD Mask operator>(Pack a, Pack b) { return b < a; }
FRESHET_HD Pack& operator+=(Pack& a, Pack b) { return a = a + b; }

FRESHET_HD Pack load(const Real* p) {
  Pack r;
  std::memcpy(&r, p, sizeof r);
  return r;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

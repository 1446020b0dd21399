// SPDX-License-Identifier: MIT
/// The two shuffles of the list build: compaction of the lanes that count, and the transpose that
/// turns rows of one particle each into the entries of a slice.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "backend/cpu/records.h"

namespace freshet {
inline namespace FRESHET_ISA {

#if !defined(FRESHET_PLAIN_LANES) && !defined(__AVX512F__)
/// For each mask the lanes that are set, first ones first.
struct CompactionTable {
  alignas(64) std::uint32_t lane[1 << lanes][lanes];
  constexpr CompactionTable() : lane{} {
    for (unsigned mask = 0; mask < (1u << lanes); ++mask) {
      int n = 0;
      for (unsigned l = 0; l < unsigned(lanes); ++l)
        if (mask >> l & 1) lane[mask][n++] = l;
    }
  }
};
inline constexpr CompactionTable compaction;
#endif

/// Writes the ids of the lanes set in m to `to` (and up to `lanes` ints in all); returns how many.
FRESHET_HD int append(int* to, Mask m, const int* id) {
  const unsigned b = bits(m);
#if defined(FRESHET_PLAIN_LANES)
  int n = 0;
  for (int l = 0; l < lanes; ++l) {
    to[n] = id[l];
    n += int(b >> l & 1);
  }
  return n;
#elif defined(__AVX512F__)
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(m.m, _mm512_loadu_si512(id)));
  return std::popcount(b);
#elif defined(__AVX2__)
  const __m256i lane = _mm256_load_si256(reinterpret_cast<const __m256i*>(compaction.lane[b]));
  const __m256i ids = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(id));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(ids, lane));
  return std::popcount(b);
#else
  // pshufb moves bytes: lane k becomes the bytes 4k ... 4k + 3
  const __m128i lane = _mm_load_si128(reinterpret_cast<const __m128i*>(compaction.lane[b]));
  const __m128i bytes =
      _mm_add_epi8(_mm_mullo_epi32(lane, _mm_set1_epi32(0x04040404)), _mm_set1_epi32(0x03020100));
  const __m128i ids = _mm_loadu_si128(reinterpret_cast<const __m128i*>(id));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_shuffle_epi8(ids, bytes));
  return std::popcount(b);
#endif
}

/// out[k * lanes + l] = rows[l * stride + k] for k, l < lanes.
FRESHET_HD void transpose_rows(const int* rows, int stride, int* out) {
#if defined(FRESHET_PLAIN_LANES)
  for (int k = 0; k < lanes; ++k)
    for (int l = 0; l < lanes; ++l) out[k * lanes + l] = rows[l * stride + k];
#else
  // quad transposes, then the 128-bit parts change places
  Floats r[lanes];
  Pack t[lanes];
  for (int l = 0; l < lanes; ++l) std::memcpy(&r[l], rows + std::size_t(l) * stride, sizeof r[l]);
  for (int g = 0; g < lanes; g += 4) {
    const Floats a = low_pairs(r[g], r[g + 2]), b = low_pairs(r[g + 1], r[g + 3]);
    const Floats c = high_pairs(r[g], r[g + 2]), d = high_pairs(r[g + 1], r[g + 3]);
    t[g] = low_pairs(a, b), t[g + 1] = high_pairs(a, b), t[g + 2] = low_pairs(c, d),
    t[g + 3] = high_pairs(c, d);
  }
  float* to = reinterpret_cast<float*>(out);
#if defined(__AVX512F__)
  for (int c = 0; c < 4; ++c) {
    const __m512 a = __m512(t[c].v), b = __m512(t[4 + c].v), d = __m512(t[8 + c].v),
                 e = __m512(t[12 + c].v);
    const __m512 p = _mm512_shuffle_f32x4(a, b, 0x44), q = _mm512_shuffle_f32x4(d, e, 0x44);
    const __m512 u = _mm512_shuffle_f32x4(a, b, 0xee), w = _mm512_shuffle_f32x4(d, e, 0xee);
    _mm512_storeu_ps(to + 16 * c, _mm512_shuffle_f32x4(p, q, 0x88));
    _mm512_storeu_ps(to + 16 * (4 + c), _mm512_shuffle_f32x4(p, q, 0xdd));
    _mm512_storeu_ps(to + 16 * (8 + c), _mm512_shuffle_f32x4(u, w, 0x88));
    _mm512_storeu_ps(to + 16 * (12 + c), _mm512_shuffle_f32x4(u, w, 0xdd));
  }
#elif defined(__AVX2__)
  for (int c = 0; c < 4; ++c) {
    const __m256 a = __m256(t[c].v), b = __m256(t[4 + c].v);
    _mm256_storeu_ps(to + 8 * c, _mm256_permute2f128_ps(a, b, 0x20));
    _mm256_storeu_ps(to + 8 * (4 + c), _mm256_permute2f128_ps(a, b, 0x31));
  }
#else
  for (int c = 0; c < 4; ++c) std::memcpy(to + 4 * c, &t[c], sizeof t[c]);
#endif
#endif
}

}  // namespace FRESHET_ISA
}  // namespace freshet

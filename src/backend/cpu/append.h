// SPDX-License-Identifier: MIT
/// The two shuffles of the list build: compaction of selected lanes, and the transpose of rows (one
/// per particle) into the entries of a slice.
#pragma once
#include <array>
#include <bit>
#include <cstdint>

#include "backend/cpu/records.h"

namespace freshet {
inline namespace FRESHET_ISA {

#if !defined(FRESHET_PLAIN_LANES) && !defined(__AVX512F__)
/// For each mask its set lanes in ascending order. An entry is a byte, so the table fits the L1
/// cache.
struct CompactionTable {
  alignas(64) std::uint8_t lane[1 << lanes][lanes];
  constexpr CompactionTable() : lane{} {
    for (unsigned mask = 0; mask < (1u << lanes); ++mask) {
      int n = 0;
      for (unsigned l = 0; l < unsigned(lanes); ++l)
        if (mask >> l & 1) lane[mask][n++] = std::uint8_t(l);
    }
  }
};
inline constexpr CompactionTable compaction;
#endif

#if !defined(FRESHET_PLAIN_LANES)
typedef int Ints __attribute__((vector_size(4 * lanes)));
FRESHET_HD Ints counting() {
  return []<int... l>(std::integer_sequence<int, l...>) { return Ints{l...}; }
  (std::make_integer_sequence<int, lanes>());
}
#endif

/// Moves the lanes of a pack that are set in a mask to the front, in ascending order.
class Compaction {
 public:
  FRESHET_HD explicit Compaction(unsigned mask) : mask_(mask) {
#if defined(__AVX2__) && !defined(__AVX512F__) && !defined(FRESHET_PLAIN_LANES)
    const auto* set = reinterpret_cast<const __m128i*>(compaction.lane[mask]);
    lane_ = _mm256_cvtepu8_epi32(_mm_loadl_epi64(set));
#elif !defined(__AVX512F__) && !defined(FRESHET_PLAIN_LANES)
    // pshufb moves bytes: lane k becomes the bytes 4k ... 4k + 3
    int set;
    std::memcpy(&set, compaction.lane[mask], sizeof set);
    lane_ = _mm_cvtepu8_epi32(_mm_cvtsi32_si128(set));
    lane_ = _mm_add_epi8(_mm_mullo_epi32(lane_, _mm_set1_epi32(0x04040404)),
                         _mm_set1_epi32(0x03020100));
#endif
  }
  FRESHET_HD int count() const { return std::popcount(mask_); }

  /// Writes the masked lanes of four-byte values. It may write up to `lanes` values in total.
  template <class T> FRESHET_HD void operator()(const T* from, T* to) const {
#if defined(FRESHET_PLAIN_LANES)
    int n = 0;
    for (int l = 0; l < lanes; ++l) {
      to[n] = from[l];
      n += int(mask_ >> l & 1);
    }
#elif defined(__AVX512F__)
    _mm512_storeu_si512(to,
                        _mm512_maskz_compress_epi32(__mmask16(mask_), _mm512_loadu_si512(from)));
#elif defined(__AVX2__)
    __m256i v = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    asm("" : "+x"(v));  // vpermd with a memory operand takes 1.5 times as long
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(v, lane_));
#else
    const __m128i v = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm_shuffle_epi8(v, lane_));
#endif
  }
  /// Writes the masked lanes of the values first, first + 1 ...
  FRESHET_HD void count_up(int first, int* to) const {
#if defined(FRESHET_PLAIN_LANES)
    int all[lanes];
    for (int l = 0; l < lanes; ++l) all[l] = first + l;
    (*this)(all, to);
#elif defined(__AVX2__) && !defined(__AVX512F__)
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                        _mm256_add_epi32(lane_, _mm256_set1_epi32(first)));
#else  // in registers: loading a vector right after its parts were stored stalls
    Ints all = counting();
    all += first;
    (*this)(reinterpret_cast<const int*>(&all), to);
#endif
  }

 private:
  unsigned mask_;
#if defined(__AVX2__) && !defined(__AVX512F__) && !defined(FRESHET_PLAIN_LANES)
  __m256i lane_;
#elif !defined(__AVX512F__) && !defined(FRESHET_PLAIN_LANES)
  __m128i lane_;
#endif
};

/// Writes `value` `lanes` times.
FRESHET_HD void fill(int* to, int value) {
  for (int l = 0; l < lanes; ++l) to[l] = value;
}

/// out[k * lanes + l] = rows[l * stride + k] for k, l < lanes.
FRESHET_HD void transpose_rows(const int* rows, int stride, int* out) {
#if defined(FRESHET_PLAIN_LANES)
  for (int k = 0; k < lanes; ++k)
    for (int l = 0; l < lanes; ++l) out[k * lanes + l] = rows[l * stride + k];
#else
  // transposes of quads, then a permutation of the 128-bit parts
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

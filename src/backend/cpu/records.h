// SPDX-License-Identifier: MIT
/// The record of a neighbour that a pass reads: its position and its values, contiguous in memory.
/// It has 16 or 32 bytes in float, so a neighbour costs one cache line. Whole records are loaded
/// and transposed in registers.
#pragma once
#include <type_traits>

#include "backend/cpu/pack.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Converts to any type. member_count() uses it to count the members of an aggregate.
struct AnyMember {
  template <class T> operator T() const;
};
template <class T, class... A> constexpr int member_count() {
  if constexpr (requires { T{A{}..., AnyMember{}}; }) return member_count<T, A..., AnyMember>();
  else return int(sizeof...(A));
}

/// Calls f(member) for each member of a flat aggregate of scalars and Vecs. Members are stored one
/// by one: with g++ 12 a memcpy of the whole aggregate goes through the stack, at four times the
/// cost.
template <class T, class F> FRESHET_HD void each_member(T& t, const F& f) {
  using Bare = std::remove_const_t<T>;
  if constexpr (!std::is_empty_v<Bare>) {
    constexpr int n = member_count<Bare>();
    static_assert(n <= 6, "a record has at most six members");
    if constexpr (n == 1) {
      auto& [a] = t;
      f(a);
    } else if constexpr (n == 2) {
      auto& [a, b] = t;
      f(a), f(b);
    } else if constexpr (n == 3) {
      auto& [a, b, c] = t;
      f(a), f(b), f(c);
    } else if constexpr (n == 4) {
      auto& [a, b, c, d] = t;
      f(a), f(b), f(c), f(d);
    } else if constexpr (n == 5) {
      auto& [a, b, c, d, e] = t;
      f(a), f(b), f(c), f(d), f(e);
    } else {
      auto& [a, b, c, d, e, g] = t;
      f(a), f(b), f(c), f(d), f(e), f(g);
    }
  }
}

template <int D, class Values> struct Record {
  static constexpr int values = std::is_empty_v<Values> ? 0 : int(sizeof(Values) / sizeof(Real));
  static constexpr int stride = D + values <= 4 ? 4 : (D + values + 7) / 8 * 8;

  FRESHET_HD static void write(Real* to, Vec<D> x, const Values& value) {
    to[0] = x.x;
    to[1] = x.y;
    if constexpr (D == 3) to[2] = x.z;
    Real* at = to + D;
    each_member(
        value, [&](const auto& member) __attribute__((always_inline)) {
          std::memcpy(at, &member, sizeof member);
          at += sizeof member / sizeof(Real);
        });
  }
};

/// Position and values of a pack of records; component c of all lanes is in lane_of[c].
template <int D> FRESHET_HD Vec<D, Pack> position(const Pack* lane_of) {
  if constexpr (D == 3) return {lane_of[0], lane_of[1], lane_of[2]};
  else return {lane_of[0], lane_of[1]};
}
template <int D, class Values> FRESHET_HD Values values(const Pack* lane_of) {
  Values v;
  if constexpr (!std::is_empty_v<Values>) std::memcpy(&v, lane_of + D, sizeof v);
  return v;
}

#if defined(FRESHET_PLAIN_LANES)

template <int stride>
FRESHET_HD void load_transposed(const Real* records, const int* index, Pack* out) {
  for (int l = 0; l < lanes; ++l)
    for (int c = 0; c < stride; ++c) out[c].v[l] = records[std::size_t(index[l]) * stride + c];
}

#else

#if defined(__AVX512F__)
FRESHET_HD Floats low_pairs(Floats a, Floats b) {
  return Floats(_mm512_unpacklo_ps(__m512(a), __m512(b)));
}
FRESHET_HD Floats high_pairs(Floats a, Floats b) {
  return Floats(_mm512_unpackhi_ps(__m512(a), __m512(b)));
}
/// The quads of the records k[0], k[4], k[8], k[12] in one register.
FRESHET_HD Floats quads(const float* p, const int* k, int stride) {
  __m512 t = _mm512_castps128_ps512(_mm_load_ps(p + std::size_t(k[0]) * stride));
  t = _mm512_insertf32x4(t, _mm_load_ps(p + std::size_t(k[4]) * stride), 1);
  t = _mm512_insertf32x4(t, _mm_load_ps(p + std::size_t(k[8]) * stride), 2);
  return Floats(_mm512_insertf32x4(t, _mm_load_ps(p + std::size_t(k[12]) * stride), 3));
}
/// The octets of the records k[0] and k[4] in one register.
FRESHET_HD Floats octets(const float* p, const int* k, int stride) {
  return Floats(
      _mm512_insertf32x8(_mm512_castps256_ps512(_mm256_load_ps(p + std::size_t(k[0]) * stride)),
                         _mm256_load_ps(p + std::size_t(k[4]) * stride), 1));
}
#elif defined(__AVX2__)
FRESHET_HD Floats low_pairs(Floats a, Floats b) {
  return Floats(_mm256_unpacklo_ps(__m256(a), __m256(b)));
}
FRESHET_HD Floats high_pairs(Floats a, Floats b) {
  return Floats(_mm256_unpackhi_ps(__m256(a), __m256(b)));
}
FRESHET_HD Floats quads(const float* p, const int* k, int stride) {
  return Floats(
      _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(p + std::size_t(k[0]) * stride)),
                           _mm_load_ps(p + std::size_t(k[4]) * stride), 1));
}
#else
FRESHET_HD Floats low_pairs(Floats a, Floats b) {
  return Floats(_mm_unpacklo_ps(__m128(a), __m128(b)));
}
FRESHET_HD Floats high_pairs(Floats a, Floats b) {
  return Floats(_mm_unpackhi_ps(__m128(a), __m128(b)));
}
FRESHET_HD Floats quads(const float* p, const int* k, int stride) {
  return Floats(_mm_load_ps(p + std::size_t(k[0]) * stride));
}
#endif

/// The 4 x 4 transpose inside each 128-bit part.
FRESHET_HD void transpose_quads(const Floats* r, Pack* out) {
  const Floats a = low_pairs(r[0], r[2]), b = low_pairs(r[1], r[3]);
  const Floats c = high_pairs(r[0], r[2]), d = high_pairs(r[1], r[3]);
  out[0] = low_pairs(a, b);
  out[1] = high_pairs(a, b);
  out[2] = low_pairs(c, d);
  out[3] = high_pairs(c, d);
}

/// out[c] = component c of the records index[0] ... index[lanes - 1].
template <int stride>
FRESHET_HD void load_transposed(const float* records, const int* index, Pack* out) {
#if defined(__AVX512F__)
  if constexpr (stride % 8 == 0) {
    for (int q = 0; q < stride; q += 8) {
      Floats r[8];
      Pack t[8];
      for (int k = 0; k < 4; ++k) r[k] = octets(records + q, index + k, stride);
      for (int k = 0; k < 4; ++k) r[4 + k] = octets(records + q, index + 8 + k, stride);
      transpose_quads(r, t);
      transpose_quads(r + 4, t + 4);
      for (int k = 0; k < 4; ++k) {
        const __m512 a = __m512(t[k].v), b = __m512(t[4 + k].v);
        out[q + k] = Floats(_mm512_shuffle_f32x4(a, b, 0x88));
        out[q + 4 + k] = Floats(_mm512_shuffle_f32x4(a, b, 0xdd));
      }
    }
    return;
  }
#endif
  for (int q = 0; q < stride; q += 4) {
    Floats r[4];
    for (int k = 0; k < 4; ++k) r[k] = quads(records + q, index + k, stride);
    transpose_quads(r, out + q);
  }
}

#endif

}  // namespace FRESHET_ISA
}  // namespace freshet

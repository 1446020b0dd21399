// SPDX-License-Identifier: MIT
/// Small vectors in 2D and 3D, and the geometry of a pair of particles.
#pragma once
#include <type_traits>

#include "core/portable.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class R = Real> struct Vec;
template <class R> struct Vec<2, R> { R x, y; };
template <class R> struct Vec<3, R> { R x, y, z; };

struct Plus {
  template <class R> FRESHET_HD R operator()(R a, R b) const { return a + b; }
};
struct Minus {
  template <class R> FRESHET_HD R operator()(R a, R b) const { return a - b; }
};
template <class R> struct TimesScalar {
  R s;
  FRESHET_HD R operator()(R a, R) const { return a * s; }
};
template <class R> struct DividedBy {
  R s;
  FRESHET_HD R operator()(R a, R) const { return a / s; }
};

/// f(a_k, b_k) for each component k.
template <int D, class R, class F> FRESHET_HD Vec<D, R> each(Vec<D, R> a, Vec<D, R> b, F f) {
  if constexpr (D == 3) return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
  else return {f(a.x, b.x), f(a.y, b.y)};
}
template <int D, class R> FRESHET_HD Vec<D, R> operator+(Vec<D, R> a, Vec<D, R> b) {
  return each(a, b, Plus{});
}
template <int D, class R> FRESHET_HD Vec<D, R> operator-(Vec<D, R> a, Vec<D, R> b) {
  return each(a, b, Minus{});
}
template <int D, class R> FRESHET_HD Vec<D, R> operator*(std::type_identity_t<R> s, Vec<D, R> a) {
  return each(a, a, TimesScalar<R>{s});
}
template <int D, class R> FRESHET_HD Vec<D, R> operator/(Vec<D, R> a, std::type_identity_t<R> s) {
  return each(a, a, DividedBy<R>{s});
}
template <int D, class R> FRESHET_HD Vec<D, R>& operator+=(Vec<D, R>& a, Vec<D, R> b) {
  return a = a + b;
}

template <int D, class R> FRESHET_HD R dot(Vec<D, R> a, Vec<D, R> b) {
  if constexpr (D == 3) return a.x * b.x + a.y * b.y + a.z * b.z;
  else return a.x * b.x + a.y * b.y;
}
template <int D, class R> FRESHET_HD R norm2(Vec<D, R> a) { return dot(a, a); }
template <int D, class R> FRESHET_HD R norm(Vec<D, R> a) { return sqrt(norm2(a)); }

template <class R> FRESHET_HD Vec<3, R> cross(Vec<3, R> a, Vec<3, R> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Component k of a. It branches on k: use it in scalar code outside hot loops.
template <int D, class R> FRESHET_HD R& component(Vec<D, R>& a, int k) {
  if constexpr (D == 3) return k == 0 ? a.x : k == 1 ? a.y : a.z;
  else return k == 0 ? a.x : a.y;
}

template <int D> FRESHET_HD Vec<D, double> to_double(Vec<D> a) {
  if constexpr (D == 3) return {double(a.x), double(a.y), double(a.z)};
  else return {double(a.x), double(a.y)};
}

/// The geometry of the pair (i, j). The compiler removes what a pair term does not use.
template <int D, class R> struct Pair {
  Vec<D, R> x;  ///< x_ij = x_i - x_j  [m]
  R r2, r;      ///< |x_ij|^2 [m^2], |x_ij| [m]
  FRESHET_HD explicit Pair(Vec<D, R> x_ij) : x(x_ij), r2(norm2(x_ij)), r(sqrt(r2)) {}
};

/// The At<R> and Neighbor<R> of a term that reads positions only.
template <class R> struct Nothing {};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Evaluates every kernel with a gradient at a row of points, one at a time or one pack at a time.
/// Uses no inline functions of the standard library, since code for several instruction sets is
/// linked into one program.
#pragma once
#include "backend/cpu/pack.h"
#include "kernels/cubic_spline.h"
#include "kernels/spiky.h"
#include "kernels/wendland.h"

namespace freshet {
inline namespace FRESHET_ISA {

constexpr int lane_kernels = 5;
constexpr int values_a_point = lane_kernels * (1 + 2 + 1 + 3);  // W and its gradient, in 2D and 3D

template <class R, template <int> class Kernel, int D>
void evaluate(const Real* const (&x)[3], int n, Real*& out) {
  const Kernel<D> W(Real(1));
  for (int k = 0; k < n; k += int(sizeof(R) / sizeof(Real))) {
    Vec<D, R> x_ij;
    std::memcpy(&x_ij.x, x[0] + k, sizeof(R));
    std::memcpy(&x_ij.y, x[1] + k, sizeof(R));
    if constexpr (D == 3) std::memcpy(&x_ij.z, x[2] + k, sizeof(R));
    const Pair<D, R> ij(x_ij);
    const R w = W(ij);
    const Vec<D, R> g = W.gradient(ij);
    std::memcpy(out + k, &w, sizeof(R));
    std::memcpy(out + n + k, &g.x, sizeof(R));
    std::memcpy(out + 2 * n + k, &g.y, sizeof(R));
    if constexpr (D == 3) std::memcpy(out + 3 * n + k, &g.z, sizeof(R));
  }
  out += (D + 1) * n;
}

template <class R, template <int> class... Kernels>
void evaluate_each(const Real* const (&x)[3], int n, Real* out) {
  (evaluate<R, Kernels, 2>(x, n, out), ...);
  (evaluate<R, Kernels, 3>(x, n, out), ...);
}

/// Writes values_a_point rows of n values; n is a multiple of 16.
template <class R> void evaluate_all(const Real* const (&x)[3], int n, Real* out) {
  evaluate_each<R, Spiky, CubicSpline, WendlandC2, WendlandC4, WendlandC6>(x, n, out);
}

void evaluate_in_packs(const Real* const (&x)[3], int n, Real* out);

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/methods.h"
#include "kernels/cubic_spline.h"
#include "kernels/wendland_smooth.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The order 2, 4 or 6 of a Wendland kernel; 0 for the cubic spline.
constexpr int wendland_order(KernelName kernel) { return 2 * int(kernel); }

/// The kernel of a scene, chosen when a run starts. It is one compiled type for all kernels, for
/// passes whose speed does not matter; its branch is the same for all particles. Its bits are those
/// of CubicSpline and WendlandSmooth.
///
///   h  support radius [m], h > 0;   W [1/m^D], gradient [1/m^(D+1)]
template <int D> struct SceneKernel {
  CubicSpline<D> cubic_spline;
  WendlandSmooth<D> wendland;
  bool cubic;
  SceneKernel(Real h, KernelName kernel)
      : cubic_spline(h),
        wendland(h, kernel == KernelName::cubic_spline ? 2 : wendland_order(kernel)),
        cubic(kernel == KernelName::cubic_spline) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    return cubic ? cubic_spline(ij) : wendland(ij);
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    return cubic ? cubic_spline.gradient(ij) : wendland.gradient(ij);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

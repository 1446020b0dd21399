// SPDX-License-Identifier: MIT
#pragma once
#include "kernels/cubic_spline.h"
#include "kernels/wendland_smooth.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The kernel that a scene asks for, found when a run starts: CubicSpline where `order` is 0, else
/// the Wendland kernel of that order. One compiled kernel for all, for passes that are not the
/// fastest; the branch is the same for all particles.
///
///   h  support radius [m], h > 0
template <int D> struct SceneKernel {
  CubicSpline<D> cubic_spline;
  WendlandSmooth<D> wendland;
  bool cubic;
  SceneKernel(Real h, int order)
      : cubic_spline(h), wendland(h, order == 0 ? 2 : order), cubic(order == 0) {}

  template <class R> FRESHET_HD R operator()(const Pair<D, R>& ij) const {
    return cubic ? cubic_spline(ij) : wendland(ij);
  }
  template <class R> FRESHET_HD Vec<D, R> gradient(const Pair<D, R>& ij) const {
    return cubic ? cubic_spline.gradient(ij) : wendland.gradient(ij);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet

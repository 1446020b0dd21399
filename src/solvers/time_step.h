// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <limits>

#include "core/field.h"
#include "freshet/time_step.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The bounds of an explicit step, with h half the support [Monaghan 1992, 2005]:
///
///   acoustic  0.4 h/(c + max |v|)    sound and particles cross less than h
///   force     0.25 sqrt(h/max |a|)   a particle at rest moves at most h/32
///   viscous   0.125 h^2/nu           explicit diffusion of momentum is stable
///
///   h [m], c [m/s], nu [m^2/s]; a is that of the previous step
///
/// Without particles max |v| and max |a| are 0, and bounds that divide by zero are infinity.
template <class B, class Fluid>
TimeStepBounds time_step_bounds(B& backend, const Fluid& f, double h, double c, double nu) {
  if (f.n == 0) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {c > 0 ? 0.4 * h / c : infinity, infinity, 0.125 * h * h / nu};
  }
  const double v2 =
      backend.max("time step", f, [=] FRESHET_LAMBDA(int i) { return double(norm2(f.v[i])); });
  const double a2 =
      backend.max("time step", f, [=] FRESHET_LAMBDA(int i) { return double(norm2(f.a[i])); });
  return {0.4 * h / (c + std::sqrt(v2)), 0.25 * std::sqrt(h / std::sqrt(a2)), 0.125 * h * h / nu};
}

}  // namespace FRESHET_ISA
}  // namespace freshet

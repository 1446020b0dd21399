// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "core/field.h"
#include "engine/plan.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The body force b(x, t) [m/s^2], an acceleration beside the solver's own.
template <int D> class BodyForce {
 public:
  explicit BodyForce(const EnginePlan& p)
      : b_(p.body_force),
        varies_(p.body_force_varies),
        halved_(b_ && !p.incompressible() && p.integrator != Integrator::symplectic_euler) {}

  /// Whether a step takes half of it at its beginning and half at its end.
  bool halved() const { return halved_; }
  /// v + dt b(x, time)
  void push(const Particles<D>& f, double time, double dt) {
    each(f, time, [&](int i, Vec<D, double> b) {
      for (int k = 0; k < D; ++k) component(f.v[i], k) += Real(dt * component(b, k));
    });
  }
  /// max |b|, 0 without one.
  double greatest(const Particles<D>& f, double time) {
    double most2 = 0;
    each(f, time, [&](int, Vec<D, double> b) { most2 = std::max(most2, norm2(b)); });
    return std::sqrt(most2);
  }

 private:
  template <class Visit> void each(const Particles<D>& f, double time, const Visit& visit) {
    if (!b_) return;
    Vec<D, double> b{};
    for (int i = 0; i < f.n; ++i) {
      if (i == 0 || varies_) {
        double x[3] = {}, value[3];
        for (int k = 0; k < D; ++k) x[k] = double(component(f.x[i], k));
        b_(x, time, value);
        for (int k = 0; k < D; ++k) component(b, k) = value[k];
      }
      visit(i, b);
    }
  }

  std::function<void(const double (&x)[3], double t, double* b)> b_;
  bool varies_, halved_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

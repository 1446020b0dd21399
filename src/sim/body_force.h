// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "core/field.h"
#include "freshet/scene.h"
#include "scene/expressions.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The scene's body force b(x, t) [m/s^2], an acceleration beside the solver's own.
template <int D> class BodyForce {
 public:
  explicit BodyForce(const Scene& s)
      : b_(s.domain.body_force),
        halved_(!s.solver.incompressible() && s.integrator() != Integrator::symplectic_euler) {}

  /// Whether a step takes half of it at its beginning and half at its end.
  bool halved() const { return halved_ && !b_.empty(); }
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
    if (b_.empty()) return;
    Vec<D, double> b{};
    for (int i = 0; i < f.n; ++i) {
      if (i == 0 || b_.depends_on_place()) {
        double x[3] = {}, value[3];
        for (int k = 0; k < D; ++k) x[k] = double(component(f.x[i], k));
        b_(x, time, value);
        for (int k = 0; k < D; ++k) component(b, k) = value[k];
      }
      visit(i, b);
    }
  }

  Expressions b_;
  bool halved_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "core/field.h"
#include "engine/plan.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Accelerations that the solver does not compute [m/s^2]: the body force b(x, t) of a plan, and a
/// custom force of the caller.
template <int D> class BodyForce {
 public:
  using Custom = std::function<void(double time, std::span<double> acceleration)>;
  explicit BodyForce(const EnginePlan& p)
      : b_(p.body_force),
        varies_(p.body_force_varies),
        second_order_(!p.incompressible && p.integrator != Integrator::symplectic_euler) {}

  void set_custom(Custom force) { custom_ = std::move(force); }

  /// Whether a step applies half of the force at its start and half at its end.
  bool halved() const { return second_order_ && (b_ || custom_); }
  /// v += dt b(x, time)
  void push(const Particles<D>& f, double time, double dt) {
    each(f, time, [&](int i, Vec<D, double> b) {
      for (int k = 0; k < D; ++k) component(f.v[i], k) += Real(dt * component(b, k));
    });
  }
  /// b(x, time) of a plan at particle i, without a custom force [m/s^2].
  Vec<D, double> at(const Particles<D>& f, int i, double time) const {
    Vec<D, double> b{};
    double x[3] = {}, value[3] = {};
    for (int k = 0; k < D && b_; ++k) x[k] = double(component(f.x[i], k));
    if (b_) b_(x, time, value);
    for (int k = 0; k < D; ++k) component(b, k) = value[k];
    return b;
  }
  /// max |b| [m/s^2]; 0 without a force.
  double greatest(const Particles<D>& f, double time) {
    double most2 = 0;
    each(f, time, [&](int, Vec<D, double> b) { most2 = std::max(most2, norm2(b)); });
    return std::sqrt(most2);
  }

 private:
  template <class Visit> void each(const Particles<D>& f, double time, const Visit& visit) {
    if (custom_) {
      acceleration_.assign(std::size_t(f.n) * D, 0);
      custom_(time, acceleration_);
    } else if (!b_) {
      return;
    }
    Vec<D, double> b{};
    for (int i = 0; i < f.n; ++i) {
      if (b_ && (i == 0 || varies_)) {
        b = at(f, i, time);
      }
      Vec<D, double> all = b;
      for (int k = 0; k < D && custom_; ++k)
        component(all, k) += acceleration_[std::size_t(i) * D + std::size_t(k)];
      visit(i, all);
    }
  }

  std::function<void(const double (&x)[3], double t, double* b)> b_;
  Custom custom_;
  std::vector<double> acceleration_;  // of the custom force
  bool varies_, second_order_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

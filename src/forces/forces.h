// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "forces/adami2013.h"
#include "forces/akinci2013.h"
#include "forces/bender2017.h"
#include "forces/gissler2017.h"
#include "forces/lind2012.h"
#include "forces/monaghan2005.h"
#include "forces/morris1997.h"
#include "forces/morris2000.h"
#include "forces/sun2017.h"
#include "forces/weiler2018.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The forces that a scene asks for, on a backend. Compiled once for each, in a file of its own.
template <int D, class B, template <int> class Kernel>
class Forces final : public NonPressureForces<D, B> {
 public:
  using typename NonPressureForces<D, B>::Fluid;

  /// The list of forces, in the order in which they act.
  Forces(const ForceParameters<D>& c, Kernel<D> W) {
    add_if_it_acts<Monaghan2005>(c, W);
    add_if_it_acts<Morris1997>(c, W);
    add_if_it_acts<Weiler2018>(c, W);
    add_if_it_acts<Akinci2013>(c, W);
    add_if_it_acts<Morris2000>(c, W);
    add_if_it_acts<Bender2017>(c, W);
    add_if_it_acts<Gissler2017>(c, W);
    add_if_it_acts<Lind2012>(c, W);
    add_if_it_acts<Adami2013>(c, W);
    add_if_it_acts<Sun2017>(c, W);
  }

  void fields(FieldMaker<D>& maker) override {
    maker.make("push", Keep::scratch, push_);
    for (const auto& force : all_) force->fields(maker);
  }

  void accelerate(B& backend, const Fluid& f, const Walls<D>& w, Real dt,
                  Field<Vec<D>> from) override {
    sum_push(backend, f, w, dt);
    add_push(backend, f);
    if (!implicit_ || !from.data) return;
    start_from(backend, f, from, dt);
    solve_ = implicit_->relax(backend, f, w, dt, push_);
    end_at(backend, f, from, dt);
  }
  void relax(B& backend, const Fluid& f, const Walls<D>& w, Real dt) override {
    if (implicit_) solve_ = implicit_->relax(backend, f, w, dt, f.v);
  }
  void push(B& backend, const Fluid& f, const Walls<D>& w, Real dt) override {
    sum_push(backend, f, w, dt);
    add_push(backend, f);
    kick(backend, f, dt);
    if (implicit_) {
      remember_v(backend, f);
      relax(backend, f, w, dt);
      add_change(backend, f, dt);
    }
    backend.share("v", f, f.v);
  }
  void shift(B& backend, const Fluid& f, Real dt) const override {
    for (const auto& force : all_) force->move(backend, f, dt);
  }

  void bound(TimeStepBounds& bounds) const override {
    for (const auto& force : all_) force->bound(bounds);
  }
  std::optional<Solve> solve() const override { return solve_; }
  void add_wall_forces(const Fluid& f, const Walls<D>& w, WallForces<D, B>& forces) const override {
    for (const auto& force : all_) force->add_wall_forces(f, w, forces);
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  /// push = the explicit accelerations, by the velocities as they are.
  void sum_push(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt) {
    const auto f = fluid;
    const auto push = push_;
    backend.share("v", f, f.v);
    if (f.kind.data) backend.share("kind", f, f.kind);
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { push[i] = Vec<D>{}; });
    for (const auto& force : all_) force->add(backend, f, w, dt, push);
  }
  void add_push(B& backend, const Fluid& fluid) const {
    const auto f = fluid;
    const auto push = push_;
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { f.a[i] += push[i]; });
  }
  void kick(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    const auto push = push_;
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { f.v[i] += dt * push[i]; });
  }
  void remember_v(B& backend, const Fluid& fluid) const {
    const auto f = fluid;
    const auto push = push_;
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { push[i] = f.v[i]; });
  }
  void add_change(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    const auto push = push_;
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { f.a[i] += (f.v[i] - push[i]) / dt; });
  }
  void start_from(B& backend, const Fluid& fluid, Field<Vec<D>> from, Real dt) const {
    const auto f = fluid;
    const auto push = push_;
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { push[i] = from[i] + dt * f.a[i]; });
  }
  void end_at(B& backend, const Fluid& fluid, Field<Vec<D>> from, Real dt) const {
    const auto f = fluid;
    const auto push = push_;
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { f.a[i] = (push[i] - from[i]) / dt; });
  }

 private:
  template <template <int, class, template <int> class> class F>
  void add_if_it_acts(const ForceParameters<D>& c, Kernel<D> W) {
    if (!F<D, B, Kernel>::acts(c)) return;
    all_.push_back(std::make_unique<F<D, B, Kernel>>(c, W));
    if (all_.back()->is_implicit()) implicit_ = all_.back().get();
  }

  std::vector<std::unique_ptr<Force<D, B>>> all_;
  Force<D, B>* implicit_ = nullptr;  // the one that solves, of `all_`
  std::optional<Solve> solve_;
  Field<Vec<D>> push_;  // scratch: accelerations [m/s^2], or velocities of the implicit solve
};

}  // namespace FRESHET_ISA
}  // namespace freshet

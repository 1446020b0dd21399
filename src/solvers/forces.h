// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "freshet/methods.h"
#include "pairs/akinci2013.h"
#include "pairs/morris1997.h"
#include "solvers/adami2013.h"
#include "solvers/bender2017.h"
#include "solvers/gissler2017.h"
#include "solvers/lind2012.h"
#include "solvers/morris2000.h"
#include "solvers/sun2017.h"
#include "solvers/weiler2018.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The forces that act beside pressure, and their parameters. A PerLiquid is indexed by liquid.
template <int D> struct ForceParameters {
  ViscosityMethod viscosity;  ///< artificial: the solver computes it, not this class
  SurfaceTensionMethod tension;
  ShiftingMethod shifting;
  bool vorticity, drag;

  Real support, h;  ///< support radius, half of it [m]
  Real spacing;     ///< [m]
  Real m, rho0;     ///< mass [kg], rest density [kg/m^D] of the densest liquid
  int liquids;
  PerLiquid lightness;    ///< rho0 over the liquid's own rest density
  PerLiquid mu;           ///< dynamic viscosity [Pa s]
  PerLiquid sigma;        ///< surface tension [N/m]
  PerLiquid gamma, beta;  ///< of Akinci 2013: cohesion, adhesion [m/s^2]
  Real nu_t, Theta;       ///< of Bender 2017 [m^2/s, m^2]
  Iterations implicit;    ///< of Weiler 2018
  Air<D> air;
  Real c0;                ///< speed of sound [m/s]; 0 for a solver without sound
  Real W_spacing;         ///< W at the distance of one spacing [1/m^D]
  Real neighbors_inside;  ///< number of neighbours in a resting lattice
  Real depth;             ///< mean distance from a plane under W: see Morris2000 [m]
  bool no_walls;          ///< no wall can take up momentum
  /// eps h^2 [m^2]. The 0.01 h^2 of the papers reduces the viscosity by 1.5 % at any resolution.
  Real eps_h2() const { return Real(1e-4f) * h * h; }
};

/// NonPressureForces on a backend. It is compiled once per backend and dimension, in its own file.
template <int D, class B, template <int> class Kernel>
class Forces final : public NonPressureForces<D, B> {
 public:
  using typename NonPressureForces<D, B>::Fluid;
  using P = ForceParameters<D>;
  Forces(const P& c, Kernel<D> W)
      : c(c),
        W(W),
        implicit_(W, c.m, c.rho0, c.eps_h2(), c.implicit),
        vorticity_{W, c.m, c.nu_t, c.Theta, {}},
        curvature_{W, c.m, c.rho0, c.support, c.spacing, c.depth, c.no_walls, {}, {}, {}} {
    switch (c.shifting) {
      case ShiftingMethod::none:
        break;
      case ShiftingMethod::lind2012:
        shifting_ = std::make_unique<Lind2012<D, B, Kernel>>(W, c.m, c.rho0, c.h, c.W_spacing);
        break;
      case ShiftingMethod::adami2013:
        shifting_ = std::make_unique<Adami2013<D, B, Kernel>>(W, c.m, c.rho0, c.h, c.c0);
        break;
      case ShiftingMethod::sun2017:
        shifting_ = std::make_unique<Sun2017<D, B, Kernel>>(W, c.m, c.rho0, c.h, c.W_spacing);
        break;
    }
    for (int k = 0; k < c.liquids; ++k)
      drag_.push_back({c.air, double(c.support), std::pow(double(c.m / c.rho0), 1.0 / D),
                       double(c.rho0 / c.lightness.of[k]), double(c.mu.of[k]),
                       double(c.sigma.of[k]), double(c.neighbors_inside)});
  }

  void fields(FieldMaker<D>& maker) override {
    maker.make("push", Keep::scratch, push_);
    if (c.tension == SurfaceTensionMethod::akinci2013)
      maker.make("surface_normal", Keep::scratch, normal_);
    if (c.tension == SurfaceTensionMethod::morris2000) curvature_.fields(maker);
    if (c.viscosity == ViscosityMethod::weiler2018) implicit_.fields(maker);
    if (c.vorticity) vorticity_.fields(maker);
    if (shifting_) shifting_->fields(maker);
  }

  void accelerate(B& backend, const Fluid& f, const Walls<D>& w, Real dt,
                  Field<Vec<D>> from) override {
    sum_push(backend, f, w, dt);
    add_push(backend, f);
    if (c.viscosity != ViscosityMethod::weiler2018 || !from.data) return;
    start_from(backend, f, from, dt);
    solve_ = implicit_.relax(backend, f, w, dt, push_, of(f, c.mu), of(f, c.lightness));
    end_at(backend, f, from, dt);
  }
  void relax(B& backend, const Fluid& f, const Walls<D>& w, Real dt) override {
    if (c.viscosity == ViscosityMethod::weiler2018)
      solve_ = implicit_.relax(backend, f, w, dt, f.v, of(f, c.mu), of(f, c.lightness));
  }
  void push(B& backend, const Fluid& f, const Walls<D>& w, Real dt) override {
    sum_push(backend, f, w, dt);
    add_push(backend, f);
    kick(backend, f, dt);
    if (c.viscosity == ViscosityMethod::weiler2018) {
      remember_v(backend, f);
      relax(backend, f, w, dt);
      add_change(backend, f, dt);
    }
    backend.share("v", f, f.v);
  }

  void shift(B& backend, const Fluid& f, Real dt) const override {
    if (shifting_) shifting_->move(backend, f, dt);
  }

  void bound(TimeStepBounds& bounds) const override {
    const double h = double(c.h), rho0 = double(c.rho0);
    const bool is_explicit =
        c.viscosity == ViscosityMethod::monaghan2005 || c.viscosity == ViscosityMethod::morris1997;
    for (int k = 0; k < c.liquids; ++k) {
      const double rho = rho0 / double(c.lightness.of[k]);
      if (is_explicit && c.mu.of[k] > 0)
        bounds.viscous = std::min(bounds.viscous, 0.125 * h * h * rho / double(c.mu.of[k]));
      if (c.tension != SurfaceTensionMethod::none && c.sigma.of[k] > 0)
        bounds.capillary =
            std::min(bounds.capillary,
                     0.25 * std::sqrt(rho * h * h * h / (2 * double(pi) * double(c.sigma.of[k]))));
    }
  }
  std::optional<Solve> solve() const override { return solve_; }
  void add_wall_forces(B& backend, const Fluid& f, const Walls<D>& w,
                       WallForces<D, B>& forces) const override;

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  /// push = the sum of the explicit accelerations at the present velocities [m/s^2].
  void sum_push(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt) {
    const auto f = fluid;
    const auto push = push_;
    backend.share("v", f, f.v);
    if (f.kind.data) backend.share("kind", f, f.kind);
    backend.for_each("forces", f, [=] FRESHET_LAMBDA(int i) { push[i] = Vec<D>{}; });
    if (c.viscosity == ViscosityMethod::monaghan2005) add_monaghan2005(backend, f, w);
    if (c.viscosity == ViscosityMethod::morris1997) add_morris1997(backend, f, w);
    if (c.tension == SurfaceTensionMethod::akinci2013) add_akinci2013(backend, f, w);
    if (c.tension == SurfaceTensionMethod::morris2000)
      curvature_.push(backend, f, w, of(f, c.sigma), of(f, c.lightness), push);
    if (c.vorticity) {
      vorticity_.turn(backend, f, dt);
      vorticity_.push(backend, f, push);
    }
    if (c.drag) add_drag(backend, f);
    if (shifting_) shifting_->find(backend, f, w, dt, of(f, c.lightness), push);
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

  static PerLiquid of(const Fluid& f, PerLiquid table) {
    table.kind = f.kind;
    return table;
  }
  /// The finish of a pass: push += lightness sum.
  struct Add {
    Field<Vec<D>> push;
    PerLiquid lightness;
    FRESHET_HD void operator()(int i, Vec<D> sum) const { push[i] += lightness[i] * sum; }
  };
  Add add_to(const Fluid& f) const { return {push_, of(f, c.lightness)}; }

  auto monaghan2005(const Fluid& f) const {
    return Monaghan2005Viscosity{W, c.m, c.eps_h2(), of(f, c.mu), f.rho, f.v};
  }
  auto monaghan2005_akinci(const Fluid& f, const Walls<D>& w) const {
    return Monaghan2005Akinci{W,   c.eps_h2(),       of(f, c.mu),          f.rho,
                              f.v, w.akinci2012.psi, w.akinci2012.friction};
  }
  auto monaghan2005_adami(const Fluid& f, const Walls<D>& w, bool at_rest) const {
    return Monaghan2005Adami{W,
                             c.m,
                             c.rho0,
                             c.eps_h2(),
                             of(f, c.mu),
                             f.rho,
                             f.v,
                             w.adami2012.friction,
                             w.adami2012.v,
                             at_rest};
  }
  void add_monaghan2005(B& backend, const Fluid& f, const Walls<D>& w) const {
    backend.sum_pairs("viscosity", f, over(f, monaghan2005(f)),
                      over(w.akinci2012, monaghan2005_akinci(f, w)),
                      over(w.adami2012, monaghan2005_adami(f, w, false)), add_to(f));
  }

  auto morris1997(const Fluid& f) const {
    return Morris1997Viscosity{W, c.m, c.eps_h2(), of(f, c.mu), f.rho, f.v};
  }
  auto morris1997_akinci(const Fluid& f, const Walls<D>& w) const {
    return Morris1997Akinci{W,   c.eps_h2(),       of(f, c.mu),          f.rho,
                            f.v, w.akinci2012.psi, w.akinci2012.friction};
  }
  auto morris1997_adami(const Fluid& f, const Walls<D>& w) const {
    return Morris1997Adami{
        W, c.m, c.rho0, c.eps_h2(), of(f, c.mu), f.rho, f.v, w.adami2012.friction, w.adami2012.v};
  }
  void add_morris1997(B& backend, const Fluid& f, const Walls<D>& w) const {
    backend.sum_pairs("viscosity", f, over(f, morris1997(f)),
                      over(w.akinci2012, morris1997_akinci(f, w)),
                      over(w.adami2012, morris1997_adami(f, w)), add_to(f));
  }

  Real per_mass() const { return Real(1 / (double(c.rho0) * std::pow(double(c.support), D))); }
  auto akinci2013(const Fluid& f) const {
    return Akinci2013Tension<D>{c.support,      c.rho0, c.m * per_mass(),
                                of(f, c.gamma), f.rho,  normal_};
  }
  auto akinci2013_adhesion(const Fluid& f, const Walls<D>& w) const {
    return Akinci2013Adhesion<D>{c.support, per_mass(), of(f, c.beta), w.akinci2012.psi};
  }
  void add_akinci2013(B& backend, const Fluid& fluid, const Walls<D>& w) const {
    const auto f = fluid;
    const auto n = normal_;
    backend.sum_pairs("surface normal", f, over(f, Akinci2013Normal{W, c.support, c.m, f.rho}),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) { n[i] = sum; });
    backend.share("surface normal", f, n);
    backend.sum_pairs("surface tension", f, over(f, akinci2013(f)),
                      over(w.akinci2012, akinci2013_adhesion(f, w)), add_to(f));
  }

  void add_drag(B& backend, const Fluid& fluid) const {
    const auto f = fluid;
    const auto push = push_;
    const Gissler2017<D> of_first = drag_.front();
    backend.sum_pairs("air", f, over(f, of_first.neighbors(f)),
                      [=] FRESHET_LAMBDA(int i, const Gissler2017Exposure<D, Real>& seen) {
                        push[i] += of_first.acceleration(f.v[i], seen);
                      });
  }

 private:
  P c;
  Kernel<D> W;
  Weiler2018<D, B, Kernel> implicit_;
  Bender2017<D, B, Kernel> vorticity_;
  Morris2000<D, B, Kernel> curvature_;
  std::unique_ptr<Shifting<D, B>> shifting_;  // null: none
  std::vector<Gissler2017<D>> drag_;          // by liquid
  std::optional<Solve> solve_;
  Field<Vec<D>> push_;    // scratch: accelerations [m/s^2], or velocities of the implicit solve
  Field<Vec<D>> normal_;  // scratch: surface normals of Akinci 2013
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The Stepper of a solver with its kernel.
#pragma once
#include <type_traits>
#include <utility>

#include "engine/parameters.h"
#include "engine/stepper.h"
#include "engine/wall_terms.h"
#include "kernels/wendland.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A visitor of fields that calls a FieldMaker.
template <int D> auto visitor_of(FieldMaker<D>& maker) {
  return [&maker](const char* name, Keep keep, auto& field) { maker.make(name, keep, field); };
}

/// `OnWalls` adds the forces on walls: on_walls(solver, fluid, walls, forces).
template <int D, class B, class Solver, class OnWalls>
class StepperOf final : public Stepper<D, B> {
 public:
  StepperOf(Solver solver, OnWalls on_walls)
      : solver_(std::move(solver)), on_walls_(std::move(on_walls)) {}

  FluidParticles<D>& fluid() override { return fluid_; }
  void fields(FieldMaker<D>& maker) override { solver_.fields(fluid_, visitor_of(maker)); }
  Confinement<D>& confinement() override { return solver_.c.confine; }
  void set_gravity(Vec<D> gravity) override {
    solver_.c.gravity = gravity;
    if constexpr (requires { on_walls_.terms; }) on_walls_.terms.c.gravity = gravity;
  }
  void set_forces(NonPressureForces<D, B>* forces) override {
    if constexpr (requires { solver_.forces; }) solver_.forces = forces;
  }
  Field<Real>* start_pressure() override {
    if constexpr (requires { fluid_.k; }) return &fluid_.k;
    else return nullptr;
  }

  Solves step(B& backend, Walls<D>& walls, const Tick& tick) override {
    Solves solves;
    if constexpr (std::is_void_v<decltype(solver_.step(backend, fluid_, walls, tick))>)
      solver_.step(backend, fluid_, walls, tick);
    else
      for (const Solve& s : solver_.step(backend, fluid_, walls, tick)) solves.add(s);
    return solves;
  }
  TimeStepBounds bounds(B& backend) override { return solver_.bounds(backend, fluid_); }
  void add_wall_forces(B& backend, const Walls<D>& walls, WallForces<D, B>& forces) override {
    on_walls_(backend, fluid_, walls, forces);
  }

 private:
  Solver solver_;
  OnWalls on_walls_;
  typename Solver::Fluid fluid_;
};

template <int D, class B, class Solver, class OnWalls>
std::unique_ptr<Stepper<D, B>> stepper_of(const Solver& solver, const OnWalls& on_walls) {
  return std::make_unique<StepperOf<D, B, Solver, OnWalls>>(solver, on_walls);
}

/// Calls f(kernel) for the plan's kernel. With `fast`, the frequent kernels are separate types and
/// the others share one. The bits are the same.
template <int D, bool fast, bool fast_c2, class F>
auto with_kernel(const EnginePlan& p, const F& f) {
  const Real support = Real(p.support);
  if constexpr (!fast) {
    return f(kernel_of<D>(p));
  } else {
    if (p.kernel == KernelName::cubic_spline) return f(CubicSpline<D>(support));
    if constexpr (fast_c2)
      if (p.kernel == KernelName::wendland_c2) return f(WendlandC2<D>(support));
    return f(WendlandSmooth<D>(support, wendland_order(p.kernel)));
  }
}

/// A solver with kernels of its own.
template <int D, class B, bool fast, template <int D_, Backend<D_>> class Solver>
std::unique_ptr<Stepper<D, B>> make_stepper_of(const EnginePlan& plan) {
  const Solver<D, B> solver{parameters_of(plan, decltype(Solver<D, B>::c){})};
  return stepper_of<D, B>(solver, MirrorTerms<Solver<D, B>>{solver});
}

/// A solver with the scene's kernel. Those for the pressure are slow to compile: they have two fast
/// kernels each.
template <int D, class B, bool fast,
          template <int D_, Backend<D_>, template <int> class> class Solver>
std::unique_ptr<Stepper<D, B>> make_stepper_of(const EnginePlan& plan) {
  using Parameters = decltype(Solver<D, B, SceneKernel>::c);
  constexpr bool incompressible = std::is_same_v<Parameters, IncompressibleParameters<D>>;
  const Parameters c = parameters_of(plan, Parameters{});
  const auto on_walls = [&] {
    if constexpr (incompressible) return IncompressibleTerms<D, B>{c, kernel_of<D>(plan)};
    else return WeaklyCompressibleTerms<Solver<D, B, SceneKernel>>{{c, kernel_of<D>(plan)}};
  }();
  return with_kernel<D, fast, !incompressible>(
      plan, [&]<template <int> class Kernel>(const Kernel<D>& W) {
        if constexpr (incompressible)
          return stepper_of<D, B>(Solver<D, B, Kernel>{{c, W}}, on_walls);
        else return stepper_of<D, B>(Solver<D, B, Kernel>{c, W}, on_walls);
      });
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The parameters of each solver from the numbers of a plan.
#pragma once
#include <algorithm>
#include <cmath>

#include "engine/plan.h"
#include "forces/force.h"
#include "kernels/scene_kernel.h"
#include "solvers/incompressible.h"
#include "solvers/mueller2003.h"
#include "solvers/weakly_compressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class R = double> Vec<D, R> vec_of(const Triple& a) {
  if constexpr (D == 3) return {R(a[0]), R(a[1]), R(a[2])};
  else return {R(a[0]), R(a[1])};
}

template <int D, class R> Solid<D, R> solid_of(const SolidPlan& s) {
  return {s.kind,      vec_of<D, R>(s.center), vec_of<D, R>(s.half), vec_of<D, R>(s.axis),
          R(s.radius), R(s.half_length),       s.fluid_inside};
}

template <int D> SceneKernel<D> kernel_of(const EnginePlan& p) {
  return SceneKernel<D>(Real(p.support), p.kernel);
}

inline Liquids liquids_of(const EnginePlan& p) {
  Liquids liquids{};
  for (Liquid& liquid : liquids.liquid) liquid.nu = Real(p.viscosity / p.rest_density);
  liquids.count = int(std::min(p.liquids.size(), std::size(liquids.liquid)));
  for (int k = 0; k < liquids.count; ++k) {
    const LiquidPlan& liquid = p.liquids[std::size_t(k)];
    liquids.liquid[k] = {Real(p.rest_density / liquid.rest_density),
                         Real(liquid.viscosity / p.rest_density),
                         Real(liquid.viscosity),
                         Real(liquid.surface_tension),
                         Real(liquid.cohesion),
                         Real(liquid.adhesion)};
  }
  return liquids;
}

/// The memory of shapes and bounces is the engine's.
template <int D> Confinement<D> confinement(const EnginePlan& p) {
  Confinement<D> c{};
  c.box = {vec_of<D, Real>(p.min), vec_of<D, Real>(p.max), Real(p.restitution), p.reflecting_sides,
           p.article};
  c.liquids = liquids_of(p);
  for (int k = 0; k < D; ++k)
    c.slack = std::max(c.slack, Real(1e-6 * std::max(std::abs(p.min[std::size_t(k)]),
                                                     std::abs(p.max[std::size_t(k)]))));
  for (int k = 0; k < D; ++k)
    if (p.periodic[std::size_t(k)])
      component(c.period, k) = Real(p.max[std::size_t(k)] - p.min[std::size_t(k)]);
  return c;
}

/// The symbols of a solver: the second argument says which parameters are asked for.
template <int D>
Mueller2003Parameters<D> parameters_of(const EnginePlan& p, Mueller2003Parameters<D> c) {
  c.h = Real(p.support);
  c.m = Real(p.mass);
  c.m_density = Real(p.mass / p.lattice_sum);
  c.rho0 = Real(p.rest_density);
  c.k = Real(p.stiffness);
  c.liquids = liquids_of(p);
  c.mu = Real(p.viscosity);
  c.gravity = vec_of<D, Real>(p.gravity);
  c.confine = confinement<D>(p);
  c.integrator = p.integrator;
  c.article = p.article;
  c.spiky_factor = p.article ? 10 : Spiky<D>::derivative;
  c.speed_limit = Real(p.speed_limit);
  return c;
}

template <int D>
WeaklyCompressibleParameters<D> parameters_of(const EnginePlan& p,
                                              WeaklyCompressibleParameters<D> c) {
  c.support = Real(p.support);
  c.h = Real(p.support / 2);
  c.m = Real(p.mass);
  c.m_density = Real(p.mass / p.lattice_sum);
  c.rho0 = Real(p.rest_density);
  c.c0 = Real(p.sound_speed);
  c.background = Real(p.background_pressure);
  c.liquids = liquids_of(p);
  c.lightest = Real(p.lightness);
  c.alpha = Real(p.artificial_viscosity);
  c.delta = Real(p.density_diffusion);
  c.acoustic_damping = Real(p.acoustic_damping);
  c.antuono = p.antuono2010;
  c.gravity = vec_of<D, Real>(p.gravity);
  c.confine = confinement<D>(p);
  c.integrator = p.integrator;
  return c;
}

template <int D>
IncompressibleParameters<D> parameters_of(const EnginePlan& p, IncompressibleParameters<D> c) {
  c.support = Real(p.support);
  c.h = Real(p.support / 2);
  c.m = Real(p.mass);
  c.m_density = Real(p.mass / p.lattice_sum);
  c.rho0 = Real(p.rest_density);
  c.liquids = liquids_of(p);
  c.most_nu = Real(p.own_viscosity);
  if (p.own_viscosity == 0)  // NonPressureForces computes the viscosity
    for (Liquid& liquid : c.liquids.liquid) liquid.nu = 0;
  c.xsph = Real(p.xsph);
  c.xsph_time = Real(p.xsph_time);
  c.repulsion = Real(square(0.1 * p.sound_speed));
  c.response = Real(p.lattice_response * p.mass * p.mass);
  c.stiffness = Real(p.lattice_stiffness);
  c.deficit = Real(p.rest_density * p.surface_deficit);
  c.gravity = vec_of<D, Real>(p.gravity);
  c.confine = confinement<D>(p);
  c.warm_start = p.warm_start;
  c.accelerated = p.accelerated;
  c.gradual = p.gradual;
  c.density = p.density;
  c.divergence = p.divergence;
  c.divergence_at_rest = p.divergence_at_rest;
  return c;
}

template <int D> ForceParameters<D> force_parameters(const EnginePlan& p) {
  const ForcesPlan& f = p.forces;
  ForceParameters<D> c{};
  c.viscosity = f.viscosity;
  c.tension = f.tension;
  c.shifting = f.shifting;
  c.vorticity = f.vorticity;
  c.drag = f.drag;
  c.support = Real(p.support);
  c.h = Real(p.support / 2);
  c.spacing = Real(p.spacing);
  c.m = Real(p.mass);
  c.rho0 = Real(p.rest_density);
  c.liquids = liquids_of(p);
  c.nu_t = Real(f.vorticity_transfer);
  c.Theta = Real(f.vorticity_inertia);
  c.implicit = f.implicit;
  c.air = {Real(f.air_density), Real(f.air_viscosity), vec_of<D, Real>(f.air_velocity)};
  c.c0 = Real(p.incompressible ? 0 : p.sound_speed);
  c.W_spacing = Real(f.W_spacing);
  c.neighbors_inside = Real(f.neighbors);
  c.depth = Real(f.mean_depth);
  c.no_walls = f.no_walls;
  return c;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// From a scene's plain words to the symbols of the forces beside pressure.
#pragma once
#include <algorithm>

#include "kernels/lattice_sum.h"
#include "kernels/scene_kernel.h"
#include "scene/solid_of.h"
#include "sim/engine.h"
#include "solvers/forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

inline int kernel_order(const Scene& s) {
  switch (s.solver.kernel) {
    case KernelName::cubic_spline:
      return 0;
    case KernelName::wendland_c2:
      return 2;
    case KernelName::wendland_c4:
      return 4;
    case KernelName::wendland_c6:
      break;
  }
  return 6;
}

/// gamma of Akinci 2013 over sigma/(rho0 h^2), with h the support radius: measured, at a support of
/// 2 spacings (docs/forces.md).
template <int D> constexpr double akinci2013_gamma = D == 2 ? 42 : 56;

template <int D> ForceParameters<D> force_parameters(const Scene& s, const Derived& d) {
  using P = ForceParameters<D>;
  P c{};
  if (s.solver.name == SolverName::mueller2003) return c;
  switch (s.viscosity_method()) {
    case ViscosityMethod::artificial:
      break;
    case ViscosityMethod::monaghan2005:
      if (!s.solver.incompressible()) c.viscosity = P::Viscosity::monaghan2005;
      break;
    case ViscosityMethod::morris1997:
      c.viscosity = P::Viscosity::morris1997;
      break;
    case ViscosityMethod::weiler2018:
      c.viscosity = P::Viscosity::weiler2018;
      break;
  }
  c.tension = typename P::Tension(int(s.solver.surface_tension_method));
  c.shifting = typename P::Shifting(int(s.solver.shifting_method));
  c.vorticity = s.solver.vorticity_method != VorticityMethod::none;
  c.drag = s.air.drag != Drag::none;
  if (!c.any()) return c;

  const double h = d.support_radius;
  c.support = Real(h);
  c.h = Real(h / 2);
  c.spacing = Real(d.spacing);
  c.m = Real(d.mass);
  c.rho0 = Real(d.rest_density);
  const auto liquids = s.liquids();
  c.liquids = int(std::min(liquids.size(), std::size_t(PerLiquid::most)));
  // all have the same; check_forces lets nobody ask for it where there is no fluid
  const double sigma = s.fluid.empty() ? 0 : s.fluid[0].surface_tension.value_or(0);
  for (int k = 0; k < c.liquids; ++k) {
    const Scene::Liquid& liquid = liquids[std::size_t(k)];
    const double gamma = akinci2013_gamma<D> * sigma / (d.rest_density * h * h);
    c.lightness.of[k] = Real(d.rest_density / liquid.rest_density);
    c.mu.of[k] = Real(liquid.viscosity);
    c.sigma.of[k] = Real(sigma);
    c.gamma.of[k] = Real(gamma);
    c.beta.of[k] = Real(s.fluid.empty() ? 0 : gamma * s.fluid[0].adhesion);
  }
  c.nu_t = Real(s.solver.vorticity_transfer.value_or(0));
  c.Theta = Real(s.solver.vorticity_inertia.value_or(h * h));
  c.implicit = {s.solver.viscosity_tolerance, 0, int(s.solver.viscosity_max_iterations)};
  c.air = {Real(s.air.density), Real(s.air.viscosity), vec_of<D, Real>(s.air.velocity)};
  c.c0 = Real(s.solver.incompressible() ? 0 : d.sound_speed);
  Vec<D> apart{};
  apart.x = Real(d.spacing);
  c.W_spacing = SceneKernel<D>(Real(h), kernel_order(s))(Pair<D, Real>(apart));
  c.neighbors_inside = Real(d.neighbors);
  c.depth = Real(mean_distance<D>(SceneKernel<D>(Real(h), kernel_order(s)), h) *
                 (D == 2 ? 2 / double(pi) : 0.5));
  c.no_walls = s.wall.empty();
  for (int side = 0; side < 2 * D; ++side)
    c.no_walls &= s.periodic(side / 2) || s.side_method(side) == WallMethod::open;
  return c;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

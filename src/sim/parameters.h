// SPDX-License-Identifier: MIT
/// From a scene's plain words to a solver's symbols.
#pragma once
#include <limits>

#include "kernels/lattice_sum.h"
#include "sim/enclosure.h"
#include "solvers/incompressible.h"
#include "solvers/mueller2003.h"
#include "solvers/weakly_compressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

inline Liquids liquids_of(const Scene& s, const Derived& d) {
  Liquids liquids{};
  for (Liquid& liquid : liquids.liquid) liquid = {1, Real(d.viscosity / d.rest_density)};
  const auto all = s.liquids();
  for (std::size_t k = 0; k < std::min(all.size(), std::size(liquids.liquid)); ++k)
    liquids.liquid[k] = {Real(d.rest_density / all[k].rest_density),
                         Real(all[k].viscosity / d.rest_density)};
  return liquids;
}

template <int D> Mueller2003Parameters<D> mueller2003_parameters(const Scene& s, const Derived& d) {
  const bool article = s.solver.scheme == Scheme::article;
  Mueller2003Parameters<D> c{};
  c.h = Real(d.support_radius);
  c.m = Real(d.mass);
  c.m_density = Real(d.mass / d.lattice_sum);
  c.rho0 = Real(d.rest_density);
  c.k = Real(d.stiffness);
  c.liquids = liquids_of(s, d);
  c.mu = Real(d.viscosity);
  c.gravity = vec_of<D, Real>(s.domain.gravity);
  c.confine = confinement<D>(s);
  c.integrator = s.integrator();
  c.article = article;
  c.spiky_factor = article ? 10 : Spiky<D>::derivative;
  c.speed_limit =
      s.solver.speed_limit ? Real(*s.solver.speed_limit) : std::numeric_limits<Real>::infinity();
  return c;
}

template <int D>
WeaklyCompressibleParameters<D> weakly_compressible_parameters(const Scene& s, const Derived& d) {
  WeaklyCompressibleParameters<D> c{};
  c.support = Real(d.support_radius);
  c.h = Real(d.support_radius / 2);
  c.m = Real(d.mass);
  c.m_density = Real(d.mass / d.lattice_sum);
  c.rho0 = Real(d.rest_density);
  c.c0 = Real(d.sound_speed);
  c.background = Real(s.solver.background_pressure);
  c.liquids = liquids_of(s, d);
  c.lightest = Real(d.lightness);
  c.alpha = Real(artificial_viscosity(s));
  c.delta = s.density_diffusion() == DensityDiffusion::none ? 0 : Real(s.solver.delta);
  c.gravity = vec_of<D, Real>(s.domain.gravity);
  c.confine = confinement<D>(s);
  c.integrator = s.integrator();
  return c;
}

template <int D, class Kernel>
IncompressibleParameters<D> incompressible_parameters(const Scene& s, const Derived& d,
                                                      const Kernel& W) {
  IncompressibleParameters<D> c{};
  c.support = Real(d.support_radius);
  c.h = Real(d.support_radius / 2);
  c.m = Real(d.mass);
  c.m_density = Real(d.mass / d.lattice_sum);
  c.rho0 = Real(d.rest_density);
  c.liquids = liquids_of(s, d);
  c.most_nu = Real(d.viscosity / d.rest_density);
  // other methods than its own are forces outside of the solver
  if (s.viscosity_method() != ViscosityMethod::monaghan2005) {
    for (Liquid& liquid : c.liquids.liquid) liquid.nu = 0;
    c.most_nu = 0;
  }
  c.xsph = Real(s.solver.xsph);
  c.repulsion = Real(square(0.1 * d.sound_speed));
  c.response = Real(lattice_response<D>(W, d.spacing, d.support_radius) * d.mass * d.mass);
  c.stiffness = Real(lattice_stiffness<D>(W, d.spacing, d.support_radius));
  c.gravity = vec_of<D, Real>(s.domain.gravity);
  c.confine = confinement<D>(s);
  c.warm_start = s.solver.warm_start;
  c.accelerated = s.solver.iteration == Iteration::nesterov;
  const int least = int(s.solver.min_iterations), most = int(s.solver.max_iterations);
  c.density = {d.density_tolerance, least, most};
  c.divergence = {s.solver.divergence_tolerance, least, most};
  return c;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
/// From a scene's plain words to a solver's symbols.
#pragma once
#include <limits>

#include "sim/enclosure.h"
#include "solvers/delta_sph.h"
#include "solvers/mueller2003.h"
#include "solvers/wcsph.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> Mueller2003Parameters<D> mueller2003_parameters(const Scene& s, const Derived& d) {
  const bool article = s.solver.scheme == Scheme::article;
  Mueller2003Parameters<D> c{};
  c.h = Real(d.support_radius);
  c.m = Real(d.mass);
  c.m_density = Real(d.mass / d.lattice_sum);
  c.rho0 = Real(d.rest_density);
  c.k = Real(d.stiffness);
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
  c.alpha = Real(s.solver.artificial_viscosity);
  c.delta = s.solver.density_diffusion == DensityDiffusion::none ? 0 : Real(s.solver.delta);
  c.gravity = vec_of<D, Real>(s.domain.gravity);
  c.confine = confinement<D>(s);
  c.integrator = s.integrator();
  return c;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

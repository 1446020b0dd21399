// SPDX-License-Identifier: MIT
/// From a scene's plain words to a solver's symbols.
#pragma once
#include "scene/setup.h"
#include "solvers/mueller2003.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> Vec<D> to_vec(const Vector& a) {
  Vec<D> v{};
  for (int k = 0; k < D; ++k) component(v, k) = Real(a[std::size_t(k)]);
  return v;
}

template <int D> Mueller2003Parameters<D> mueller2003_parameters(const Scene& s, const Derived& d) {
  const bool article = s.solver.scheme == Scheme::article;
  Mueller2003Parameters<D> c{};
  c.dt = Real(s.time.step);
  c.h = Real(d.support_radius);
  c.m = Real(d.mass);
  c.m_density = Real(d.mass / d.lattice_sum);
  c.rho0 = Real(d.rest_density);
  c.k = Real(d.stiffness);
  c.mu = Real(d.viscosity);
  c.gravity = to_vec<D>(s.domain.gravity);
  c.walls = {to_vec<D>(s.domain.min), to_vec<D>(s.domain.max), Real(s.walls.restitution), article};
  c.kick_drift = article;
  c.spiky_factor = article ? 10 : Spiky<D>::derivative;
  c.speed_limit =
      s.solver.speed_limit ? Real(*s.solver.speed_limit) : std::numeric_limits<Real>::infinity();
  return c;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <limits>

#include "backend/reference/reference_backend.h"
#include "backend/reference/reference_sets_impl.h"
#include "solvers/delta_sph.h"
#include "solvers/mueller2003.h"
#include "solvers/wcsph.h"

namespace freshet {

/// A small square (2D) or cube (3D) of free fluid: no gravity, no walls. It starts deformed and
/// compressed, with positive pressure everywhere. Negative pressure would make particles clump,
/// which hides the order of an integrator.
template <int D, class Solver, int side = D == 2 ? 12 : 7> struct Patch {
  static constexpr Real spacing = Real(0.1);

  ReferenceBackend<D> backend;
  typename Solver::Fluid fluid;
  Walls<D> walls;

  explicit Patch(Solver solver) : solver_(std::move(solver)) {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= side;
    backend.add_set(fluid, n);
    backend.allocate(fluid, Keep::kept, fluid.id);
    backend.allocate(fluid, Keep::kept, fluid.x);
    backend.allocate(fluid, Keep::kept, fluid.v);
    solver_.fields(
        fluid, [&](const char*, Keep keep, auto& field) { backend.allocate(fluid, keep, field); });
    backend.add_set(walls.akinci2012, 0);
    backend.add_set(walls.adami2012, 0);
    backend.add_set(walls.monaghan2009, 0);
    for (int i = 0; i < n; ++i) {
      const Real x = Real(i % side) * spacing, y = Real(i / side % side) * spacing;
      fluid.id[i] = std::uint64_t(i);
      fluid.rho[i] = solver_.c.rho0 * Real(1.02);
      fluid.x[i].x = x - Real(0.05) * x * x;
      fluid.x[i].y = y - Real(0.04) * y * y + Real(0.03) * x;
      fluid.v[i].x = std::sin(3 * y);
      fluid.v[i].y = std::cos(2 * x) * std::sin(y);
      if constexpr (D == 3) {
        const Real z = Real(i / (side * side)) * spacing;
        fluid.x[i].z = z - Real(0.06) * z * x;
        fluid.v[i].z = std::sin(2 * x + y);
      }
    }
  }

  void run(double dt, int steps) {
    for (int k = 0; k < steps; ++k) solver_.step(backend, fluid, walls, {Real(dt), k});
  }

 private:
  Solver solver_;
};

/// A single liquid, without a viscosity of its own.
inline Liquids one_liquid() {
  Liquids all{};
  for (Liquid& liquid : all.liquid) liquid.lightness = 1;
  return all;
}

/// Parameters of the paper's scheme, in units where the density of a particle at rest is 1.
template <int D> Mueller2003Parameters<D> mueller2003_patch(Integrator integrator) {
  const Real spacing = Real(0.1), speed_of_sound = 10;
  Mueller2003Parameters<D> c{};
  c.h = 2 * spacing;
  c.m = c.m_density = D == 2 ? spacing * spacing : spacing * spacing * spacing;
  c.rho0 = Real(0.5);
  c.liquids = one_liquid();
  c.k = speed_of_sound * speed_of_sound;
  c.mu = Real(0.1);
  c.integrator = integrator;
  c.spiky_factor = Spiky<D>::derivative;
  c.speed_limit = std::numeric_limits<Real>::infinity();
  return c;
}

/// Parameters of the weakly compressible solvers, in units where the density at rest is 1.
template <int D> WeaklyCompressibleParameters<D> weakly_compressible_patch(Integrator integrator) {
  const Real spacing = Real(0.1);
  WeaklyCompressibleParameters<D> c{};
  c.h = Real(1.2) * spacing;
  c.support = 2 * c.h;
  c.m = c.m_density = D == 2 ? spacing * spacing : spacing * spacing * spacing;
  c.rho0 = Real(0.8);
  c.liquids = one_liquid();
  c.c0 = 10;
  c.alpha = Real(0.05);
  c.delta = Real(0.1);
  c.integrator = integrator;
  return c;
}

}  // namespace freshet

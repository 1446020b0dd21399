// SPDX-License-Identifier: MIT
#pragma once
#include <limits>

#include "backend/reference/reference_backend.h"
#include "solvers/mueller2003.h"

namespace freshet {

/// A small square of fluid that nothing holds: no gravity, and no wall within reach. It starts
/// stirred and squeezed, under pressure everywhere: tension would pull particles into each other,
/// and such an encounter hides the order of an integrator.
struct FreePatch {
  static constexpr int side = 12;
  static constexpr Real spacing = Real(0.1), speed_of_sound = 10;

  ReferenceBackend<2> backend;
  Mueller2003Fluid<2> fluid;

  FreePatch() {
    const int n = side * side;
    backend.add_set(fluid, n);
    backend.allocate(fluid, Keep::kept, fluid.id);
    backend.allocate(fluid, Keep::kept, fluid.x);
    backend.allocate(fluid, Keep::kept, fluid.v);
    fluid.fields(
        [&](const char*, Keep keep, auto& field) { backend.allocate(fluid, keep, field); });
    for (int i = 0; i < n; ++i) {
      const Real x = Real(i % side) * spacing, y = Real(i / side) * spacing;
      fluid.id[i] = std::uint64_t(i);
      fluid.x[i] = {x - Real(0.05) * x * x, y - Real(0.04) * y * y + Real(0.03) * x};
      fluid.v[i] = {std::sin(3 * y), std::cos(2 * x) * std::sin(y)};
    }
  }

  /// Of a step of dt: the paper's scheme, in units in which a resting particle's density is 1.
  static Mueller2003Parameters<2> parameters(double dt) {
    Mueller2003Parameters<2> c{};
    c.dt = Real(dt);
    c.h = 2 * spacing;
    c.m = c.m_density = spacing * spacing;
    c.rho0 = Real(0.5);
    c.k = speed_of_sound * speed_of_sound;
    c.mu = Real(0.1);
    c.walls = {{-100, -100}, {100, 100}, Real(0.5), false};
    c.spiky_factor = Spiky<2>::derivative;
    c.speed_limit = std::numeric_limits<Real>::infinity();
    return c;
  }

  void run(const Mueller2003Parameters<2>& c, int steps) {
    Mueller2003<2, ReferenceBackend<2>> solver{c};
    for (int k = 0; k < steps; ++k) solver.step(backend, fluid, k == 0);
  }
};

}  // namespace freshet

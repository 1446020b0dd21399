// SPDX-License-Identifier: MIT
/// Helpers for tests of the forces besides pressure.
#pragma once
#include <cmath>
#include <cstring>
#include <functional>

#include "io/checkpoint.h"
#include "engine/select.h"
#include "sim/small_scenes.h"

namespace freshet::test {

inline bool compiled(const std::string& solver) {
  return has_solver(
      parse_scene(
          "[domain]\nmax = [1, 1]\n[particles]\nspacing = 0.1\n[fluid]\nmin = [0, 0]\nmax = "
          "[1, 1]\n[solver]\nname = \"" +
              solver + "\"\n[time]\nend = 1\nstep = 0.001\n",
          "solver.toml")
          .solver.name);
}

/// Sets the velocity of every particle by its position: v[0 ... D) from x[0 ... D).
inline void set_velocities(Simulation& sim,
                           const std::function<void(const Real* x, Real* v)>& velocity) {
  Checkpoint c = sim.checkpoint();
  const auto array = [&](const std::string& name) -> Real* {
    for (auto& a : c.arrays)
      if (a.name == name) return reinterpret_cast<Real*>(a.bytes.data());
    return nullptr;
  };
  const Real* x = array("fluid/x");
  Real* v = array("fluid/v");
  const ParticleView f = sim.fluid();
  const auto D = std::size_t(f.dimension);
  for (std::size_t i = 0; i < f.size(); ++i) velocity(x + D * i, v + D * i);
  sim.restore(c);
}

/// Sum over the particles of a function of position and velocity.
inline double sum_over(const Simulation& sim,
                       const std::function<double(const Real* x, const Real* v)>& value) {
  const ParticleView f = sim.fluid();
  const auto D = std::size_t(f.dimension);
  double sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += value(&f.x[D * i], &f.v[D * i]);
  return sum;
}

}  // namespace freshet::test

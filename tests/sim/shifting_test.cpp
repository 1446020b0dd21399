// SPDX-License-Identifier: MIT
// Vortices without a surface, whose pressures below zero pull particles into strings unless they
// are shifted.
#include <gtest/gtest.h>

#include <numbers>

#include "sim/forced.h"

namespace freshet::test {
namespace {

constexpr double pi = std::numbers::pi;

/// How fast the energy of Taylor and Green's vortices at Re = 100 falls, over 16 pi^2/Re.
double decay_over_exact(const std::string& more) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1, 1]\ngravity = [0, 0]\nperiodic = \"xy\"\n[particles]\n"
      "spacing = 0.025\nsupport_radius = 0.1\n[fluid]\nmin = [0, 0]\nmax = [1, 1]\n"
      "viscosity = 10\n[solver]\nname = \"delta_sph\"\nkernel = \"wendland_c2\"\n"
      "viscosity_method = \"monaghan2005\"\nsound_speed = 20.0\n" +
      more + "[time]\nend = 100\nstep = 5e-4\n[checks]\nwhen_wrong = \"warn\"\n");
  set_velocities(sim, [](const Real* x, Real* v) {
    const double X = 2 * pi * double(x[0]), Y = 2 * pi * double(x[1]);
    v[0] = Real(-std::cos(X) * std::sin(Y));
    v[1] = Real(std::sin(X) * std::cos(Y));
  });
  while (sim.time() < 0.1) sim.step();
  const double begin = sim.time(), before = sim.statistics().kinetic_energy;
  while (sim.time() < 0.7) sim.step();
  const double rate = std::log(before / sim.statistics().kinetic_energy) / (sim.time() - begin);
  return rate / (16 * pi * pi / 100);
}

TEST(Sun2017, LetsVorticesTurn) {
  if (!compiled("delta_sph")) GTEST_SKIP() << "not compiled in this build";
  EXPECT_LT(decay_over_exact("shifting_method = \"sun2017\"\n"), 1.2);  // 1.17 at 40 a side
  EXPECT_GT(decay_over_exact(""), 1.3) << "not the particles' own merit";
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// The bulk viscosity of delta_sph that damps sound.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene/model/expressions.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// The kinetic energy that a standing sound wave has after two periods, over that of the start.
double left_after_two_periods(const std::string& solver) {
  Simulation sim = simulation_of(
      "[domain]\nmax = [1.0, 0.2]\nperiodic = \"xy\"\ngravity = [0, 0]\n"
      "[particles]\nspacing = 0.02\nsupport_radius = 0.06\n"
      "[fluid]\nmin = [0, 0]\nmax = [1.0, 0.2]\nvelocity_field = [\"0.01*sin(2*pi*x)\", \"0\"]\n"
      "[solver]\nname = \"delta_sph\"\nkernel = \"wendland_c2\"\nsound_speed = 10\n"
      "artificial_viscosity = 0\ndensity_diffusion = \"none\"\n" +
          solver + "[time]\nend = 0.2\nstep = 0.0005\n",
      "cpu");
  const double start = sim.statistics().kinetic_energy;
  while (!sim.finished()) sim.step();
  return sim.statistics().kinetic_energy / start;
}

/// A bulk viscosity nu makes the energy of a sound wave decay as exp(-nu k^2 t).
TEST(AcousticDamping, DampsSoundAsItsBulkViscosityDoes) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  const double k = 2 * 3.14159265, nu = 0.5 * 0.03 * 10;
  EXPECT_GT(left_after_two_periods(""), 0.95);
  EXPECT_NEAR(std::exp(-nu * k * k * 0.2), left_after_two_periods("acoustic_damping = 0.5\n"),
              0.03);
}

}  // namespace
}  // namespace freshet::test

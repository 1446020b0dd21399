// SPDX-License-Identifier: MIT
// solver.density_correction = "gradual" in still, deep and broken water.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sim/forced.h"

namespace freshet::test {
namespace {

std::string tank(const std::string& fluid, const std::string& solver, const std::string& slip) {
  return "[domain]\nmax = [0.4, 2]\n[particles]\nspacing = 0.02\nsupport_radius = 0.06\n" + fluid +
         "[solver]\nkernel = \"wendland_c2\"\n" + solver +
         "[walls]\nmethod = \"ghost\"\nslip = \"" + slip +
         "\"\n[time]\nend = 2\nstep = \"adaptive\"\nstep_max = 0.004\n";
}

/// The mean kinetic energy per mass from a time on [J/kg].
double energy_at_end(const std::string& scene, double from = 1.5) {
  Simulation sim = simulation_of(scene, "cpu");
  double sum = 0, steps = 0;
  while (!sim.finished()) {
    sim.step();
    if (sim.time() < from) continue;
    const ParticleView f = sim.fluid();
    double v2 = 0;
    for (const Real v : f.v) v2 += double(v) * double(v);
    sum += v2 / 2 / double(f.size());
    ++steps;
  }
  return sum / steps;
}

/// A column of 80 spacings that starts with the pressure of its weight.
std::string deep(const std::string& slip, const std::string& more) {
  return tank("[fluid]\nmin = [0, 0]\nmax = [0.4, 1.6]\npressure = \"hydrostatic\"\n",
              "name = \"dfsph\"\n" + more, slip);
}

TEST(GradualCorrection, KeepsDeepWaterStill) {
  if (!compiled("dfsph")) GTEST_SKIP() << "not compiled in this build";
  const double still = energy_at_end(deep("free_slip", ""));
  EXPECT_LT(still, 4e-4);
  EXPECT_GT(energy_at_end(deep("free_slip", "density_correction = \"at_once\"\n")), 5 * still);
}

/// The pressures of still water follow its motion in every step, also where a warm start is within
/// the tolerance.
TEST(GradualCorrection, LetsWaterComeToRest) {
  if (!compiled("dfsph")) GTEST_SKIP() << "not compiled in this build";
  const auto water = [](const std::string& more) {
    return "[domain]\nmax = [0.25, 0.3]\n[particles]\nspacing = 0.01\nsupport_radius = 0.03\n"
           "[fluid]\nmin = [0, 0]\nmax = [0.25, 0.25]\npressure = \"hydrostatic\"\n"
           "[solver]\nname = \"dfsph\"\nkernel = \"wendland_c2\"\n" +
           more + "[time]\nend = 5\nstep = \"adaptive\"\nstep_max = 0.004\n";
  };
  const double still = energy_at_end(water(""), 4);
  EXPECT_LT(still, 3e-6 * 9.81 * 0.25);
  EXPECT_GT(energy_at_end(water("min_iterations = 1\n"), 4), 10 * still);
}

/// Ghosts of no-slip sides that move against the fluid would change its density.
TEST(GradualCorrection, KeepsDeepWaterStillBetweenNoSlipGhosts) {
  if (!compiled("dfsph")) GTEST_SKIP() << "not compiled in this build";
  EXPECT_LT(energy_at_end(deep("no_slip", "")), 4e-4);
}

/// A column that falls over between such sides: its particles keep the speed of a fall.
TEST(GradualCorrection, ThrowsNoParticlesBetweenNoSlipGhosts) {
  if (!compiled("dfsph")) GTEST_SKIP() << "not compiled in this build";
  for (const std::string correction : {"gradual", "at_once"}) {
    Simulation sim = simulation_of(
        "[domain]\nmax = [0.6, 0.6]\n[particles]\nspacing = 0.03\n[fluid]\nmin = [0, 0]\nmax = "
        "[0.21, 0.42]\n[solver]\nname = \"dfsph\"\ndensity_correction = \"" +
            correction +
            "\"\n[walls]\nmethod = \"ghost\"\n[time]\nend = 1\nstep = 0.005\n[checks]\n"
            "when_wrong = \"warn\"\n",
        "cpu");
    double fastest2 = 0;
    while (!sim.finished()) {
      sim.step();
      const ParticleView f = sim.fluid();
      for (std::size_t i = 0; i < f.size(); ++i)
        fastest2 =
            std::max(fastest2, double(f.v[2 * i] * f.v[2 * i] + f.v[2 * i + 1] * f.v[2 * i + 1]));
    }
    EXPECT_LT(fastest2, 36) << correction;  // [m²/s²]
  }
}

/// Water that fell apart comes together again: a gap of one layer, which the support spans, closes.
TEST(GradualCorrection, ClosesVoids) {
  for (const std::string solver : {"dfsph", "iisph"}) {
    if (!compiled(solver)) continue;
    Simulation sim = simulation_of(
        tank("[[fluid]]\nmin = [0, 0]\nmax = [0.4, 0.2]\n[[fluid]]\nmin = [0, 0.22]\nmax = [0.4, "
             "0.42]\n",
             "name = \"" + solver + "\"\ndensity_correction = \"gradual\"\n", "free_slip"),
        "cpu");
    while (!sim.finished()) sim.step();
    const ParticleView f = sim.fluid();
    double height = 0;
    for (std::size_t i = 0; i < f.size(); ++i) height += f.position(i, 1) / double(f.size());
    EXPECT_NEAR(height, 0.2, 0.003) << solver;  // 0.21 with the gap
  }
}

}  // namespace
}  // namespace freshet::test

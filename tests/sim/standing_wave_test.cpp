// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/model/expressions.h"
#include "sim/forced.h"

namespace freshet::test {
namespace {

constexpr double period = 0.9935, k = 2 * std::numbers::pi / 1.36, depth = 0.3;  // s, 1/m, m

/// One wavelength of a wave whose surface is flat at the start, on a floor without friction.
std::string wave(const std::string& correction) {
  return "[domain]\nmax = [1.36, 0.5]\nperiodic = \"x\"\n[particles]\nspacing = 0.04\n"
         "support_radius = 0.12\n[fluid]\nmin = [0, 0]\nmax = [1.36, 0.3]\nviscosity = 0\n"
         "pressure = \"hydrostatic\"\nvelocity_field = "
         "[\"-0.08769*sin(4.61999*x)*cosh(4.61999*y)\", "
         "\"0.08769*cos(4.61999*x)*sinh(4.61999*y)\"]\n[solver]\nname = \"dfsph\"\n"
         "kernel = \"wendland_c2\"\nxsph = 0\ndensity_correction = \"" +
         correction +
         "\"\n[walls]\nmethod = \"ghost\"\nslip = \"free_slip\"\n[time]\nend = 3\nstep = "
         "\"adaptive\"\nstep_max = 0.004\n";
}

struct Mode {
  double u, v;
};
/// The velocity of the wave of linear theory at a place, over that of its surface.
Mode mode_at(double x, double y) {
  return {-std::sin(k * x) * std::cosh(k * y) / std::sinh(k * depth),
          std::cos(k * x) * std::sinh(k * y) / std::sinh(k * depth)};
}

/// The projection of the velocities on the wave [m/s].
double amplitude(const ParticleView& f) {
  double product = 0, square = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const Mode m = mode_at(f.position(i, 0), f.position(i, 1));
    product += m.u * double(f.v[2 * i]) + m.v * double(f.v[2 * i + 1]);
    square += m.u * m.u + m.v * m.v;
  }
  return product / square;
}

/// The wave's root mean square in the third period over that in the first.
double kept(const std::string& correction) {
  Simulation sim = simulation_of(wave(correction), "cpu");
  double first = 0, third = 0, firsts = 0, thirds = 0;
  while (!sim.finished()) {
    sim.step();
    const double a = amplitude(sim.fluid());
    if (sim.time() < period) first += a * a, ++firsts;
    if (sim.time() > 2 * period) third += a * a, ++thirds;
  }
  return std::sqrt(third / thirds / (first / firsts));
}

TEST(StandingWave, KeepsItsHeightWhereErrorsOfTheDensityAreRemovedGradually) {
  if (!compiled("dfsph") || !reads_expressions()) GTEST_SKIP() << "not compiled in this build";
  EXPECT_GT(kept("gradual"), 0.9);
  EXPECT_LT(kept("at_once"), 0.5);
}

}  // namespace
}  // namespace freshet::test

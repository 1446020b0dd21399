// SPDX-License-Identifier: MIT
// What surface tension does to weightless drops: Laplace's pressure, the frequency at which a drop
// rings, and nothing to its momentum.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <numbers>

#include "sim/forced.h"

namespace freshet::test {
namespace {

constexpr double spacing = 0.001, rho0 = 1000, pi = std::numbers::pi;

struct Drop {
  int dimension;
  const char *solver, *method;
  double sigma = 0.05, viscosity = 0.1;
};

/// A drop, `spacings` in radius, in the middle of nothing.
Simulation drop_of(const Drop& d, double spacings, double step) {
  const double length = spacing * (2 * spacings + 10);
  const auto vector = [&](double x) {
    return d.dimension == 2 ? fmt::format("[{0}, {0}]", x) : fmt::format("[{0}, {0}, {0}]", x);
  };
  const bool weakly = std::string(d.solver) == "wcsph";
  return simulation_of(fmt::format(
      "[domain]\nmax = {}\ngravity = {}\n[walls]\nmethod = \"open\"\n[particles]\nspacing = "
      "{}\nsupport_radius = {}\n"
      "[fluid]\nshape = \"sphere\"\ncenter = {}\nradius = {}\nviscosity = {}\n"
      "surface_tension = {}\n[solver]\nname = \"{}\"\nsurface_tension_method = \"{}\"\n{}\n[time]\n"
      "end = 100\nstep = {}\n",
      vector(length), vector(0), spacing, 2 * spacing, vector(length / 2), spacings * spacing,
      d.viscosity, d.sigma, d.solver, d.method,
      weakly ? "sound_speed = 3.0\nviscosity_method = \"monaghan2005\"" : "xsph = 0", step));
}

// What moves apart from all else is kept, also where the particles meet nobody.
TEST(Akinci2013, KeepsMomentum) {
  for (const char* solver : {"wcsph", "dfsph"}) {
    if (!compiled(solver)) continue;
    Simulation sim = drop_of({2, solver, "akinci2013"}, 8, 2e-4);
    set_velocities(sim, [](const Real* x, Real* v) {
      v[0] = Real(0.05 + 2 * (double(x[1]) - 0.013));
      v[1] = Real(-0.02);
    });
    const auto before = sim.statistics().momentum;
    for (int n = 0; n < 300; ++n) sim.step();
    const auto after = sim.statistics().momentum;
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(before[k], after[k], 1e-4 * std::abs(before[0])) << solver;
  }
}

// A square becomes round: its second moments stay alike, its corners come in.
TEST(Akinci2013, MakesASquareRound) {
  if (!compiled("wcsph")) GTEST_SKIP() << "not compiled in this build";
  const auto fourth = [](const Simulation& sim) {  // <r^4 cos(4 phi)>/<r^4>: 0 of what is round
    const ParticleView f = sim.fluid();
    double x0 = 0, y0 = 0, sum = 0, all = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      x0 += double(f.x[2 * i]) / double(f.size());
      y0 += double(f.x[2 * i + 1]) / double(f.size());
    }
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double x = double(f.x[2 * i]) - x0, y = double(f.x[2 * i + 1]) - y0;
      const double r2 = x * x + y * y;
      sum += x * x * x * x - 6 * x * x * y * y + y * y * y * y;
      all += r2 * r2;
    }
    return sum / all;
  };
  Simulation sim = simulation_of(
      "[domain]\nmax = [0.04, 0.04]\ngravity = [0, 0]\n[walls]\nmethod = \"open\"\n[particles]\n"
      "spacing = 0.001\n[fluid]\nmin = [0.01, 0.01]\nmax = [0.03, 0.03]\nviscosity = 0.1\n"
      "surface_tension = 0.0728\n[solver]\nname = \"wcsph\"\nsound_speed = 3.0\n"
      "viscosity_method = \"monaghan2005\"\nsurface_tension_method = \"akinci2013\"\n[time]\nend = "
      "1\nstep = 1e-4\n");
  const double before = fourth(sim);
  for (int n = 0; n < 4000; ++n) sim.step();
  EXPECT_LT(before, -0.1);
  EXPECT_GT(fourth(sim), 0.25 * before);
}

// Capillary waves no longer than the support have to be told in time.
TEST(Akinci2013, BoundsTheStep) {
  if (!compiled("wcsph")) GTEST_SKIP() << "not compiled in this build";
  Simulation sim = drop_of({2, "wcsph", "akinci2013"}, 5, 1e-4);
  sim.step();
  const double bound = 0.25 * std::sqrt(rho0 * std::pow(spacing, 3) / (2 * pi * 0.05));
  EXPECT_NEAR(1, sim.bounds().capillary / bound, 1e-5);
}

}  // namespace
}  // namespace freshet::test

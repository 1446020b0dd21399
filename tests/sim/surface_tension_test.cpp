// SPDX-License-Identifier: MIT
// Surface tension of drops without gravity: Laplace pressure, shape and momentum.
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

/// A drop with a radius of `spacings` in empty space.
Simulation drop_of(const Drop& d, double spacings, double step) {
  const double length = spacing * (2 * spacings + 10);
  const auto vector = [&](double x) {
    return d.dimension == 2 ? fmt::format("[{0}, {0}]", x) : fmt::format("[{0}, {0}, {0}]", x);
  };
  const bool weakly = std::string(d.solver) == "wcsph" || std::string(d.solver) == "delta_sph";
  return simulation_of(fmt::format(
      "[domain]\nmax = {}\ngravity = {}\n[walls]\nmethod = \"open\"\n[particles]\nspacing = "
      "{}\nsupport_radius = {}\n"
      "[fluid]\nshape = \"sphere\"\ncenter = {}\nradius = {}\nviscosity = {}\n"
      "surface_tension = {}\n[solver]\nname = \"{}\"\nsurface_tension_method = "
      "\"{}\"\n{}{}\n[time]\n"
      "end = 100\nstep = {}\n",
      vector(length), vector(0), spacing, (std::string(d.method) == "morris2000" ? 3 : 2) * spacing,
      vector(length / 2), spacings * spacing, d.viscosity, d.sigma, d.solver, d.method,
      std::string(d.method) == "morris2000" ? "kernel = \"wendland_c2\"\n" : "",
      weakly ? "sound_speed = 3.0\nviscosity_method = \"monaghan2005\"" : "xsph = 0", step));
}

// Pair forces conserve the momentum of a drop that shears in empty space.
TEST(Akinci2013, ConservesMomentum) {
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

// The fourth angular moment of a square falls to less than a quarter.
TEST(Akinci2013, MakesASquareRound) {
  if (!compiled("wcsph")) GTEST_SKIP() << "not compiled in this build";
  const auto fourth = [](const Simulation& sim) {  // <r^4 cos(4 phi)>/<r^4>: 0 for a disc
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

TEST(Akinci2013, HoldsADropTogetherIn3D) {
  if (!compiled("dfsph")) GTEST_SKIP() << "not compiled in this build";
  Simulation sim = drop_of({3, "dfsph", "akinci2013", 0.0728, 0.001}, 6, 2e-4);
  for (int n = 0; n < 250; ++n) sim.step();
  const ParticleView f = sim.fluid();
  double sum2 = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) sum2 += std::pow(double(f.x[3 * i + k]) - 11 * spacing, 2);
  const double of_ball = std::sqrt(0.6) * 6 * spacing;
  EXPECT_LT(std::sqrt(sum2 / double(f.size())), 1.5 * of_ball) << "a drop that bursts is at 3.4 by now";
}

/// Mean pressure within half the radius of a drop, relative to the Laplace pressure.
double laplace(const Drop& d, double spacings, int steps) {
  Simulation sim = drop_of(d, spacings, 2e-4);
  const auto D = std::size_t(d.dimension);
  const double middle = spacing * (spacings + 5);
  double sum = 0, count = 0;
  for (int n = 0; n < steps; ++n) {
    sim.step();
    if (n < steps / 2) continue;
    const ParticleView f = sim.fluid();
    for (std::size_t i = 0; i < f.size(); ++i) {
      double r2 = 0;
      for (std::size_t k = 0; k < D; ++k) r2 += std::pow(double(f.x[D * i + k]) - middle, 2);
      if (r2 > std::pow(spacing * spacings / 2, 2)) continue;
      sum += double(f.pressure[i]);
      ++count;
    }
  }
  return sum / count / (double(D - 1) * d.sigma / (spacing * spacings));
}

// The support radius of 3 spacings is a quarter of the 2D drop's radius and 3/7 of the 3D drop's.
TEST(Morris2000, GivesTheLaplacePressure) {
  for (const char* solver : {"wcsph", "delta_sph", "iisph"}) {
    if (!compiled(solver)) continue;
    EXPECT_NEAR(1, laplace({2, solver, "morris2000", 0.05, 0.02}, 12, 4000), 0.1) << solver;
  }
  for (const char* solver : {"wcsph", "iisph"}) {
    if (!compiled(solver)) continue;
    EXPECT_NEAR(1, laplace({3, solver, "morris2000", 0.05, 0.02}, 7, 800), 0.15) << solver;
  }
}

// A free drop must not start to move.
TEST(Morris2000, DoesNotMoveADrop) {
  for (const char* solver : {"wcsph", "dfsph"}) {
    if (!compiled(solver)) continue;
    Simulation sim = drop_of({2, solver, "morris2000", 0.05, 0.02}, 8, 2e-4);
    for (int n = 0; n < 500; ++n) sim.step();
    const auto momentum = sim.statistics().momentum;
    const double mass = rho0 * pi * std::pow(8 * spacing, 2),
                 capillary = std::sqrt(0.05 / (rho0 * 8 * spacing));
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(0, momentum[k] / (mass * capillary), 1e-4) << solver;
  }
}

// Water between two walls, as high as they are apart. The contact angle is 90°, so the surface
// stays flat.
TEST(Morris2000, KeepsAContactAngleOf90Degrees) {
  for (const char* method : {"akinci2012", "ghost"}) {
    if (!compiled("dfsph")) continue;
    Simulation sim = simulation_of(fmt::format(
        "[domain]\nmax = [0.016, 0.03]\n[walls]\nmethod = \"{}\"\n[particles]\nspacing = 0.001\n"
        "support_radius = 0.003\n[fluid]\nmin = [0, 0]\nmax = [0.016, 0.016]\nviscosity = 0.02\n"
        "surface_tension = 0.05\n[solver]\nname = \"dfsph\"\nsurface_tension_method = "
        "\"morris2000\"\n"
        "[time]\nend = 1\nstep = 2e-4\n",
        method));
    for (int n = 0; n < 1500; ++n) sim.step();
    const ParticleView f = sim.fluid();
    double edge = 0, middle = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double x = double(f.x[2 * i]), y = double(f.x[2 * i + 1]);
      double& top = std::abs(x - 0.008) < 0.003 ? middle : edge;
      if (std::abs(x - 0.008) < 0.003 || std::abs(x - 0.008) > 0.005) top = std::max(top, y);
    }
    EXPECT_NEAR(middle, edge, 1.0 * spacing) << method;
    EXPECT_NEAR(middle, 0.0155, 1.0 * spacing) << method;
  }
}

// The time step must resolve capillary waves of the length of half the support radius, here a
// spacing.
TEST(Akinci2013, LimitsTheTimeStep) {
  if (!compiled("wcsph")) GTEST_SKIP() << "not compiled in this build";
  Simulation sim = drop_of({2, "wcsph", "akinci2013"}, 5, 1e-4);
  sim.step();
  const double bound = 0.25 * std::sqrt(rho0 * std::pow(spacing, 3) / (2 * pi * 0.05));
  EXPECT_NEAR(1, sim.bounds().capillary / bound, 1e-5);
}

}  // namespace
}  // namespace freshet::test

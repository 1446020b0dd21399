// SPDX-License-Identifier: MIT
// Air drag on single drops and on surfaces.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <numbers>

#include "sim/forced.h"

namespace freshet::test {
namespace {

/// A cube of liquid in a wind: one particle if its half width is half a spacing.
std::string in_air(const std::string& solver, double spacing, double radius,
                   const std::string& gravity, const std::string& velocity, const std::string& wind,
                   double step, const std::string& drag = "gissler2017") {
  return fmt::format(
      "[domain]\nmin = [-12, -12, -12]\nmax = [12, 12, 12]\ngravity = {}\n[walls]\nmethod = "
      "\"open\"\n[particles]\nspacing = {}\n[fluid]\nmin = [-{}, -{}, -{}]\nmax = [{}, {}, {}]\n"
      "velocity = {}\n{}[solver]\nname = \"{}\"\n{}[air]\n{}[time]\nend = "
      "100\nstep = {}\n",
      gravity, spacing, radius, radius, radius, radius, radius, radius, velocity,
      drag == "none" ? "" : "surface_tension = 0.0728\n", solver,
      solver == "wcsph" ? "sound_speed = 40\n" : "",
      drag == "none" ? "" : fmt::format("drag = \"{}\"\nvelocity = {}\n", drag, wind), step);
}

class Air : public ::testing::TestWithParam<const char*> {};

// A drop of 1 mm falls at the speed where the drag equals its weight: the drag of Liu, Mather and
// Reitz for a sphere that the air stream flattens.
TEST_P(Air, DropFallsAtItsTerminalSpeed) {
  if (!compiled(GetParam())) GTEST_SKIP() << "not compiled in this build";
  const double d = 0.001, rho_air = 1.2, mu_air = 1.8e-5, g = 9.81, sigma = 0.0728;
  Simulation sim = simulation_of(
      in_air(GetParam(), d, d / 2, "[0, -9.81, 0]", "[0, -2, 0]", "[0, 0, 0]", 0.002));
  ASSERT_EQ(1u, sim.fluid().size());
  while (sim.time() < 2) sim.step();
  const double speed = -double(sim.fluid().v[1]);

  const double L = std::cbrt(3 * d * d * d / (4 * std::numbers::pi));
  const double re = 2 * rho_air * speed * L / mu_air;
  const double C = 24 / re * (1 + std::pow(re, 2.0 / 3) / 6);
  // 1 + exp(-pi/(omega t_d)) = 1.93 times the flattening in equilibrium, for the viscosity of water
  const double t_d = 2 * 1000 * L * L / (5 * 0.001);
  const double omega = std::sqrt(8 * sigma / (1000 * L * L * L) - 1 / (t_d * t_d));
  const double y =
      rho_air * speed * speed * L / sigma / 12 * (1 + std::exp(-std::numbers::pi / (omega * t_d)));
  const double A = std::numbers::pi * std::pow(L * (1 + y / 2), 2);
  const double drag = 0.5 * rho_air * speed * speed * C * (1 + 2.632 * y) * A;
  EXPECT_NEAR(1, drag / (1000 * d * d * d * g), 0.01) << speed << " m/s, y " << y;
  EXPECT_GT(speed, 3);
  EXPECT_LT(speed, 6);
}

// Air that moves with the liquid gives the velocities of a run without air.
TEST_P(Air, OfTheSameVelocityExertsNoForce) {
  if (!compiled(GetParam())) GTEST_SKIP() << "not compiled in this build";
  const auto run = [&](const std::string& drag) {
    Simulation sim = simulation_of(
        in_air(GetParam(), 0.01, 0.035, "[0, 0, 0]", "[3, -1, 0.5]", "[3, -1, 0.5]", 1e-4, drag));
    sim.step();
    double most = 0;
    for (std::size_t i = 0; i < sim.fluid().size(); ++i)
      most = std::max(most, std::abs(double(sim.fluid().v[3 * i]) - 3));
    return most;
  };
  EXPECT_EQ(run("none"), run("gissler2017"));
}

TEST_P(Air, PushesTheWindwardSideOnly) {
  if (!compiled(GetParam())) GTEST_SKIP() << "not compiled in this build";
  const auto velocities = [&](const std::string& wind) {
    Simulation sim =
        simulation_of(in_air(GetParam(), 0.01, 0.035, "[0, 0, 0]", "[0, 0, 0]", wind, 1e-5));
    sim.step();
    double windward = 0, lee = 0;
    for (std::size_t i = 0; i < sim.fluid().size(); ++i) {
      const double v = double(sim.fluid().v[3 * i]);
      const Real* x = &sim.fluid().x[3 * i];
      const bool middle = std::abs(x[1]) < Real(0.015) && std::abs(x[2]) < Real(0.015);
      if (x[0] < Real(-0.025) && middle) windward += v;
      if (x[0] > Real(0.025) && middle) lee += v;
    }
    return std::pair(windward, lee);
  };
  const auto [w0, l0] = velocities("[0, 0, 0]");
  const auto [w1, l1] = velocities("[20, 0, 0]");
  const double windward = w1 - w0, lee = l1 - l0;
  EXPECT_GT(windward, 0);
  EXPECT_LT(std::abs(lee), 0.05 * windward);
  // 1/2 rho v² on the square of each of 9 particles in the middle of the side. They have 20
  // neighbours; with 21.3, two thirds of the full number, a particle is a piece of surface and no
  // drop.
  const double one = 0.5 * 1.2 * 400 * 1e-4 / (1000 * 1e-6) * 1e-5;
  EXPECT_NEAR(1.04, windward / (9 * one), 0.05);
}
INSTANTIATE_TEST_SUITE_P(Solvers, Air, ::testing::Values("wcsph", "dfsph"));

}  // namespace
}  // namespace freshet::test

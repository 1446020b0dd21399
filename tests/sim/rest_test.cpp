// SPDX-License-Identifier: MIT
// Fluid that starts at rest: its density, its hydrostatic pressure, the weight on its floor.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

struct Still {
  int dimension;
  const char *solver, *kernel;
};
void PrintTo(const Still& s, std::ostream* out) {
  *out << s.dimension << "D " << s.solver << ", " << s.kernel;
}

std::string solver_table(const char* solver, const char* kernel) {
  return std::string("[solver]\nname = \"") + solver + "\"\nsound_speed = 40.0\nkernel = \"" +
         kernel + "\"\n";
}

class Rest : public ::testing::TestWithParam<Still> {};

TEST_P(Rest, HasItsRestDensityInside) {
  const auto [dimension, solver, kernel] = GetParam();
  const bool flat = dimension == 2;
  Simulation sim = simulation_of(
      std::string("[domain]\n") +
      (flat ? "max = [3.0, 3.0]\ngravity = [0, 0]\n"
            : "max = [3.0, 3.0, 3.0]\ngravity = [0, 0, 0]\n") +
      "[walls]\nmethod = \"open\"\n[particles]\nspacing = 0.1\nsupport_radius = 0.24\n[fluid]\n" +
      (flat ? "min = [1, 1]\nmax = [2, 2]\n" : "min = [1, 1, 1]\nmax = [2, 2, 2]\n") +
      solver_table(solver, kernel) + "[time]\nend = 1.0\nstep = 1e-6\n");
  sim.step();
  const ParticleView f = sim.fluid();
  int inside = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    bool deep = true;
    for (int d = 0; d < dimension; ++d) {
      const Real x = f.x[i * std::size_t(dimension) + std::size_t(d)];
      deep &= x > Real(1.24) && x < Real(1.76);
    }
    if (!deep) continue;
    EXPECT_NEAR(1000, double(f.density[i]), 10);
    ++inside;
  }
  EXPECT_GE(inside, 30);
}

INSTANTIATE_TEST_SUITE_P(
    Kernels, Rest,
    ::testing::Values(Still{2, "wcsph", "cubic_spline"}, Still{2, "wcsph", "wendland_c2"},
                      Still{2, "wcsph", "wendland_c4"}, Still{2, "wcsph", "wendland_c6"},
                      Still{3, "wcsph", "cubic_spline"}, Still{3, "wcsph", "wendland_c2"},
                      Still{3, "wcsph", "wendland_c4"}, Still{3, "wcsph", "wendland_c6"},
                      Still{2, "delta_sph", "wendland_c2"}, Still{3, "delta_sph", "cubic_spline"}));

/// A tank 1 m wide, with 0.5 m of water under hydrostatic pressure.
std::string tank(const char* solver, const std::string& walls, double viscosity) {
  return "[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\n"
         "max = [1.0, 0.5]\npressure = \"hydrostatic\"\n[walls]\n" +
         walls + solver_table(solver, "wendland_c2") +
         "artificial_viscosity = " + std::to_string(viscosity) +
         "\n[time]\nend = 3.0\nstep = 0.0004\n";
}

// Tait's equation below a column of initial depth s:
// rho = rho0 (1 + 7 g s/c²)^(1/7), p = rho0 g s.
TEST(Hydrostatic, StartsWithThePressureOfItsDepth) {
  Simulation sim =
      simulation_of(tank("delta_sph", "method = \"ghost\"\nslip = \"free_slip\"\n", 0.05));
  sim.step();
  const ParticleView f = sim.fluid();
  const double c2 = 1600, B = 1000 * c2 / 7;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double depth = 0.5 - double(f.x[2 * i + 1]);  // it has sunk by less than 0.1 mm
    const double rho = double(f.density[i]);
    EXPECT_NEAR(std::pow(1 + 7 * 9.81 * depth / c2, 1.0 / 7), rho / 1000, 0.01);
    if (depth > 0.1) {
      EXPECT_NEAR(1, B * (std::pow(rho / 1000, 7) - 1) / (1000 * 9.81 * depth), 0.01) << depth;
    }
  }
}

struct Floor {
  const char *solver, *method;
};
void PrintTo(const Floor& f, std::ostream* out) { *out << f.solver << ", " << f.method; }
class StillWater : public ::testing::TestWithParam<Floor> {};

TEST_P(StillWater, WeighsOnItsFloor) {
  const auto [solver, method] = GetParam();
  const std::string slip = std::string(method) == "monaghan2009" ? "" : "slip = \"free_slip\"\n";
  Simulation sim = simulation_of(
      tank(solver, "method = \"" + std::string(method) + "\"\ny_max = \"open\"\n" + slip, 0.3));
  const double weight = 1000 * 9.81 * 0.5;
  double floor = 0, all = 0, sides = 0;
  int counted = 0;
  for (int k = 0; k < 5000; ++k) {
    sim.step();
    if (k < 2500 || k % 5) continue;
    const auto forces = sim.wall_forces();
    floor -= forces[2][1];
    for (const Vector& force : forces) all -= force[1];
    sides += forces[1][0] - forces[0][0];
    ++counted;
  }
  EXPECT_NEAR(1, floor / counted / weight, 0.02);
  EXPECT_NEAR(1, all / counted / weight, 0.02);
  EXPECT_NEAR(2 * 0.5 * 1000 * 9.81 * 0.5 * 0.5, sides / counted, 0.15 * 2500);
}

INSTANTIATE_TEST_SUITE_P(Walls, StillWater,
                         ::testing::Values(Floor{"wcsph", "akinci2012"},
                                           Floor{"wcsph", "adami2012"}, Floor{"wcsph", "ghost"},
                                           Floor{"delta_sph", "akinci2012"},
                                           Floor{"delta_sph", "adami2012"},
                                           Floor{"delta_sph", "ghost"},
                                           Floor{"wcsph", "monaghan2009"}));

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Tanks that move with the fluid in them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/rotation.h"
#include "engine/select.h"
#include "freshet/simulation.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

struct Kind {
  const char* solver;
  SolverName name;
  const char* walls;
};
constexpr Kind kinds[] = {{"dfsph", SolverName::dfsph, "open"},
                          {"wcsph", SolverName::wcsph, "open"},
                          {"delta_sph", SolverName::delta_sph, "adami2012"}};

Simulation tank_of(const Kind& kind, const std::string& tables) {
  return Simulation(parse_scene(tables +
                                    "side = \"inside\"\nmotion = \"moved\"\n[walls]\nmethod = \"" +
                                    kind.walls + "\"\n[solver]\nname = \"" + kind.solver +
                                    "\"\n[time]\nend = 1\nstep = \"adaptive\"\nstep_max = 0.002\n",
                                "test.toml"));
}

/// The largest distance of a particle from the middle of the tank along its axes, over half its
/// sides.
double reach_in_tank(const Simulation& sim, std::vector<double> half) {
  const BodyState tank = sim.bodies()[0];
  const Rotation turn(tank.orientation);
  const auto x = sim.fluid().x;
  const std::size_t d = half.size();
  double most = 0;
  for (std::size_t i = 0; i < x.size(); i += d) {
    Vec<3, double> p{double(x[i]) - tank.position[0], double(x[i + 1]) - tank.position[1],
                     d == 3 ? double(x[i + 2]) - tank.position[2] : 0.0};
    p = turn.inverse(p);
    for (std::size_t k = 0; k < d; ++k)
      most = std::max(most, std::abs(component(p, int(k))) / half[k]);
  }
  return most;
}

const std::string shaken_2d =
    "domain.max = [2, 1]\nparticles.spacing = 0.02\n"
    "[fluid]\nmin = [0.7, 0.3]\nmax = [1.3, 0.5]\n"
    "[body]\nmin = [0.7, 0.3]\nmax = [1.3, 0.7]\n"
    "position = [\"0.1*(1 - cos(8*t))\", \"0\"]\nangle = \"10*sin(4*t)\"\n";
const std::string shaken_3d =
    "domain.max = [2, 1, 1]\nparticles.spacing = 0.05\n"
    "[fluid]\nmin = [0.7, 0.3, 0.3]\nmax = [1.3, 0.5, 0.7]\n"
    "[body]\nmin = [0.7, 0.3, 0.3]\nmax = [1.3, 0.7, 0.7]\n"
    "position = [\"0.1*(1 - cos(8*t))\", \"0\", \"0\"]\nangle = \"10*sin(4*t)\"\n";

TEST(Tanks, KeepTheirFluid) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  for (const Kind& kind : kinds)
    for (const bool flat : {true, false}) {
      if (!has_solver(kind.name)) continue;
      SCOPED_TRACE(std::string(kind.solver) + (flat ? " in 2D" : " in 3D"));
      Simulation sim = tank_of(kind, flat ? shaken_2d : shaken_3d);
      while (sim.time() < 0.4) sim.step();
      EXPECT_GT(sim.bodies()[0].position[0], 1.15);
      const std::vector<double> half{0.3, 0.2, 0.2};
      EXPECT_LT(reach_in_tank(sim, {half.begin(), half.end() - flat}), 1.0);
    }
}

// A tank in free fall under its own acceleration: the fluid is pushed by its back wall with the
// force of its mass times the acceleration.
TEST(Tanks, PushTheirFluidWithItsMassTimesTheAcceleration) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  if (!has_solver(SolverName::dfsph)) GTEST_SKIP() << "not compiled in this build";
  Simulation sim =
      tank_of(kinds[0],
              "domain.max = [2, 1]\ndomain.gravity = [0, 0]\nparticles.spacing = 0.02\n"
              "[fluid]\nmin = [0.3, 0.3]\nmax = [0.9, 0.7]\n"
              "[body]\nmin = [0.3, 0.3]\nmax = [0.9, 0.7]\n"
              "position = [\"t^2\", \"0\"]\n");
  double impulse = 0;
  while (sim.time() < 0.4) {
    sim.step();
    impulse += sim.bodies()[0].force[0] * sim.time_steps().last;
  }
  const double mass = 1000 * 0.6 * 0.4;
  EXPECT_NEAR(-mass * 2 * 0.4, impulse, 0.03 * mass * 2 * 0.4);
}

}  // namespace
}  // namespace freshet::test

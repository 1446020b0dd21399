// SPDX-License-Identifier: MIT
// Tanks that move with the fluid in them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/rotation.h"
#include "engine/select.h"
#include "freshet/simulation.h"
#include "scene/model/body_shape.h"
#include "scene/model/expressions.h"
#include "scene/model/setup.h"

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

/// A tank that the fluid moves.
Simulation free_tank(const std::string& tables, const std::string& walls = "open",
                     const std::string& solver = "dfsph") {
  return Simulation(parse_scene(
      tables + "side = \"inside\"\nmotion = \"free\"\n[walls]\nmethod = \"" + walls +
          "\"\n[solver]\nname = \"" + solver + (solver == "wcsph" ? "\"\nsound_speed = 20" : "\"") +
          "\n[time]\nend = 1\nstep = \"adaptive\"\nstep_max = 0.002\n",
      "test.toml"));
}

// A full tank is hit: in the end it has the velocity of both together.
TEST(FreeTanks, ShareTheirMomentumWithTheFluid) {
  if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  const double mass = 80, fluid = 1000 * 0.4 * 0.2;
  for (const char* solver : {"dfsph", "wcsph"}) {
    Simulation sim = free_tank(
        "domain.max = [2, 1]\ndomain.gravity = [0, 0]\nparticles.spacing = 0.02\n"
        "[fluid]\nmin = [0.3, 0.3]\nmax = [0.7, 0.5]\n"
        "[body]\nmin = [0.3, 0.3]\nmax = [0.7, 0.5]\nmass = 80\nvelocity = [1, 0]\n",
        "open", solver);
    const auto momentum = [&] {
      return sim.statistics().momentum[0] + mass * sim.bodies()[0].velocity[0];
    };
    while (sim.time() < 0.5) sim.step();
    EXPECT_NEAR(mass, momentum(), 1e-3 * mass) << solver;
    EXPECT_NEAR(mass / (mass + fluid), sim.bodies()[0].velocity[0], 0.03) << solver;
    EXPECT_LT(reach_in_tank(sim, {0.2, 0.1}), 1.0) << solver;
  }
}

TEST(FreeTanks, FallWithTheirFluidAndComeToRest) {
  if (!moves_free_bodies()) GTEST_SKIP() << "built without Bullet";
  for (const bool flat : {true, false}) {
    SCOPED_TRACE(flat ? "2D" : "3D");
    Simulation sim =
        free_tank(flat ? "domain.max = [1, 1]\nparticles.spacing = 0.02\n"
                         "[fluid]\nmin = [0.3, 0.2]\nmax = [0.7, 0.3]\n"
                         "[body]\nmin = [0.3, 0.2]\nmax = [0.7, 0.5]\nmass = 20\n"
                       : "domain.max = [1, 1, 1]\nparticles.spacing = 0.04\n"
                         "[fluid]\nmin = [0.3, 0.2, 0.4]\nmax = [0.7, 0.32, 0.6]\n"
                         "[body]\nmin = [0.3, 0.2, 0.4]\nmax = [0.7, 0.5, 0.6]\nmass = 5\n",
                  "reflection");
    while (sim.time() < 0.15) sim.step();
    const double tank_mass = flat ? 20 : 5, fluid = flat ? 40 : 9.6;
    const double momentum = sim.statistics().momentum[1] + tank_mass * sim.bodies()[0].velocity[1];
    EXPECT_NEAR(-9.81 * sim.time(), momentum / (tank_mass + fluid), 0.02) << "in free fall";
    while (sim.time() < 1) sim.step();
    const BodyState tank = sim.bodies()[0];
    EXPECT_NEAR(0.15, tank.position[1], 0.01) << "the tank lies on the floor";
    EXPECT_LT(std::abs(tank.velocity[1]), 0.05);
    EXPECT_LT(std::abs(tank.orientation[2]), 0.02) << "and is upright";
    const std::vector<double> half{0.2, 0.15, 0.1};
    EXPECT_LT(reach_in_tank(sim, {half.begin(), half.end() - flat}), 1.0);
  }
}

// The moments of thin shells, by their closed forms.
TEST(FreeTanks, AreShellsWithAnEvenMass) {
  const auto shape = [](const char* domain, const char* body) {
    return body_shape(
        with_defaults(parse_scene(std::string("domain.max = ") + domain +
                                      "\nparticles.spacing = 0.05\ntime = { end = 1, step = 1e-4 "
                                      "}\nsolver.name = \"dfsph\"\n"
                                      "[[body]]\nside = \"inside\"\nmotion = \"free\"\nmass = 3\n" +
                                      body,
                                  "test.toml"))
            .body[0]);
  };
  const BodyShape ball =
      shape("[1, 1, 1]", "shape = \"sphere\"\ncenter = [0.5, 0.5, 0.5]\nradius = 0.3\n");
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(2.0 / 3 * 3 * 0.09, ball.density() * ball.inertia[k][k], 0.003);
  const BodyShape disc = shape("[1, 1]", "shape = \"sphere\"\ncenter = [0.5, 0.5]\nradius = 0.3\n");
  EXPECT_NEAR(3 * 0.09, disc.density() * disc.inertia[2][2], 0.001);
  // a thin square frame of side a has m a²/3
  const BodyShape square = shape("[1, 1]", "min = [0.2, 0.2]\nmax = [0.8, 0.8]\n");
  EXPECT_NEAR(3 * 0.36 / 3, square.density() * square.inertia[2][2], 1e-9);
  EXPECT_NEAR(0.5, square.center.x, 1e-12);
  // of a triangle's sides, those that meet in the right angle are closer to it
  const BodyShape triangle =
      shape("[1, 1]", "shape = \"polygon\"\npoints = [[0.1, 0.1], [0.5, 0.1], [0.1, 0.4]]\n");
  const double perimeter = 0.4 + 0.3 + 0.5;
  EXPECT_NEAR((0.4 * 0.3 + 0.3 * 0.1 + 0.5 * 0.3) / perimeter, triangle.center.x, 1e-12);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// A caller may change force, gravity, positions and velocities while a simulation runs.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/select.h"
#include "freshet/simulation.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

/// Water without gravity in the middle of a domain without walls.
std::string drop(const std::string& solver, const std::string& domain = "") {
  return "domain = { max = [1, 1], gravity = [0, 0]" + domain +
         " }\nparticles = { spacing = 0.05 }\nwalls = { method = \"open\" }\n"
         "fluid = { min = [0.4, 0.4], max = [0.6, 0.6] }\ntime = { end = 1, step = 0.0005 }\n"
         "solver = { name = \"" +
         solver + "\"" +
         (solver == "mueller2003" ? ", stiffness = 100"
          : solver == "dfsph"     ? ""
                                  : ", sound_speed = 10") +
         " }\n";
}

constexpr const char* solvers[] = {"mueller2003", "wcsph", "delta_sph", "dfsph"};

Simulation simulation_of(const std::string& scene) {
  return Simulation(parse_scene(scene, "drop"));
}

/// The mean velocity.
Vector velocity(const Simulation& sim) {
  Vector v(2, 0);
  const ParticleView f = sim.fluid();
  for (std::size_t k = 0; k < f.v.size(); ++k) v[k % 2] += double(f.v[k]) / double(f.size());
  return v;
}

TEST(Interventions, ForceHasTheBitsOfTheSameBodyForce) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  for (const char* solver : solvers) {
    if (std::string(solver) == "mueller2003") continue;
    SCOPED_TRACE(solver);
    Simulation a = simulation_of(drop(solver, ", body_force = [\"2 - x\", \"3*t\"]"));
    Simulation b = simulation_of(drop(solver));
    b.set_force([](const ParticleView& f, double time, std::span<double> acceleration) {
      for (std::size_t i = 0; i < f.size(); ++i) {
        acceleration[2 * i] += 2 - double(f.x[2 * i]);
        acceleration[2 * i + 1] += 3 * time;
      }
    });
    for (int k = 0; k < 20; ++k) a.step(), b.step();
    EXPECT_EQ(a.state_sha256(), b.state_sha256());
    EXPECT_EQ(a.bounds().force, b.bounds().force);
    b.set_force({});
    const Vector before = velocity(b);
    for (int k = 0; k < 20; ++k) b.step();
    EXPECT_NEAR(velocity(b)[0], before[0], 1e-4);
  }
}

TEST(Interventions, GravityChangesFromTheNextStepOn) {
  for (const char* solver : solvers) {
    SCOPED_TRACE(solver);
    if (!has_solver(parse_scene(drop(solver), "drop").solver.name)) continue;
    Simulation sim = simulation_of(drop(solver));
    sim.set_gravity({4, 0});
    for (int k = 0; k < 20; ++k) sim.step();
    const Vector v = velocity(sim);
    EXPECT_NEAR(v[0], 4 * sim.time(),
                0.06 * 4 * sim.time());  // the first half kick of leapfrog was without gravity
    EXPECT_NEAR(v[1], 0, 1e-4);
    EXPECT_EQ(sim.scene().domain.gravity, (Vector{4, 0}));
  }
}

TEST(Interventions, InvalidGravityIsRejectedAndChangesNothing) {
  Simulation sim = simulation_of(drop("wcsph"));
  for (const Vector& wrong :
       {Vector{1}, Vector{1, 2, 3}, Vector{0, std::numeric_limits<double>::quiet_NaN()}})
    EXPECT_THROW(sim.set_gravity(wrong), Error);
  EXPECT_EQ(sim.scene().domain.gravity, (Vector{0, 0}));
}

TEST(Interventions, PositionsAndVelocitiesCanBeWritten) {
  for (const char* solver : solvers) {
    SCOPED_TRACE(solver);
    if (!has_solver(parse_scene(drop(solver), "drop").solver.name)) continue;
    Simulation sim = simulation_of(drop(solver));
    const auto fluid = sim.edit_fluid();
    ASSERT_EQ(fluid.x.size(), 2 * sim.fluid().size());
    for (std::size_t i = 0; i < fluid.x.size(); i += 2) {
      fluid.x[i] += Real(0.1);
      fluid.v[i + 1] = Real(-2);
    }
    const Real x = sim.fluid().x[0];
    const Statistics before = sim.statistics();
    for (int k = 0; k < 10; ++k) sim.step();
    const Statistics after = sim.statistics();
    EXPECT_NEAR(double(x), 0.525, 1e-6);  // the first lattice place, moved by 0.1 m
    EXPECT_NEAR(after.height_mean, before.height_mean - 2 * sim.time(), 1e-4);
  }
}

}  // namespace
}  // namespace freshet::test

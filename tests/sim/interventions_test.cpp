// SPDX-License-Identifier: MIT
// A caller may change force, gravity, positions and velocities while a simulation runs.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/select.h"
#include "freshet/checkpoint.h"
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

/// Without this error, the run failed ten steps later and blamed the time step.
TEST(Interventions, ForceThatIsNaNIsNamed) {
  for (const char* solver : solvers) {
    SCOPED_TRACE(solver);
    if (!has_solver(parse_scene(drop(solver), "drop").solver.name)) continue;
    Simulation sim = simulation_of(drop(solver));
    sim.set_force([](const ParticleView&, double time, std::span<double> acceleration) {
      if (time > 0.004) acceleration[3] = std::nan("");
    });
    std::string error;
    try {
      for (int k = 0; k < 100; ++k) sim.step();
    } catch (const Error& e) {
      error = e.what();
    }
    EXPECT_TRUE(error.starts_with("set_force: error: the acceleration of particle ")) << error;
    EXPECT_NE(std::string::npos, error.find("is nan; return finite numbers")) << error;
    EXPECT_LT(sim.time(), 0.01);
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

TEST(Interventions, ParticlesCanBeAddedAndRemoved) {
  for (const char* solver : solvers)
    for (const char* backend : {"reference", "cpu"}) {
      SCOPED_TRACE(std::string(solver) + " " + backend);
      const Scene scene = parse_scene(drop(solver), "drop", {{"solver.backend", backend}});
      if (!has_solver(scene.solver.name)) continue;
      Simulation sim(scene);
      for (int k = 0; k < 5; ++k) sim.step();
      const std::size_t before = sim.fluid().size();
      const std::vector<Real> x{Real(0.2), Real(0.2), Real(0.8), Real(0.2)},
          v{Real(1), Real(0), Real(0), Real(2)};
      EXPECT_EQ(sim.add_particles(x, v), before);
      ASSERT_EQ(sim.fluid().size(), before + 2);
      EXPECT_NEAR(double(sim.fluid().density[before]), 1000, 1e-3);
      sim.wall_forces();  // searches between the steps
      for (int k = 0; k < 5; ++k) sim.step();
      const Frame frame = sim.frame();
      EXPECT_NEAR(frame.x[2 * before], 0.2 + 5 * 0.0005, 1e-5);
      EXPECT_NEAR(frame.x[2 * before + 3], 0.2 + 2 * 5 * 0.0005, 1e-5);
      sim.remove_particles(std::vector<std::uint64_t>{before + 1, 0});
      for (int k = 0; k < 5; ++k) sim.step();
      ASSERT_EQ(sim.fluid().size(), before);
      for (const std::uint64_t id : sim.fluid().id) EXPECT_TRUE(id != 0 && id != before + 1) << id;
      EXPECT_EQ(sim.add_particles(x), before + 2) << "ids are not used again";
    }
}

TEST(Interventions, AddedParticlesAreInCheckpoints) {
  Simulation sim = simulation_of(drop("delta_sph")), other = simulation_of(drop("delta_sph"));
  sim.add_particles(std::vector<Real>{Real(0.2), Real(0.2)});
  for (int k = 0; k < 5; ++k) sim.step();
  const Checkpoint checkpoint = sim.checkpoint();
  other.restore(checkpoint);
  for (Simulation* s : {&sim, &other}) {
    for (int k = 0; k < 5; ++k) s->step();
    s->add_particles(std::vector<Real>{Real(0.8), Real(0.8)});
    for (int k = 0; k < 5; ++k) s->step();
  }
  EXPECT_EQ(sim.state_sha256(), other.state_sha256());
  EXPECT_EQ(sim.kept_sha256(), other.kept_sha256());
}

TEST(Interventions, WrongParticlesAreRejectedAndNothingChanges) {
  Simulation sim = simulation_of(drop("wcsph"));
  const std::string before = sim.state_sha256();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_THROW(sim.add_particles(std::vector<Real>{1, 2, 3}), Error);
  EXPECT_THROW(sim.add_particles(std::vector<Real>{1, nan}), Error);
  EXPECT_THROW(sim.add_particles(std::vector<Real>{1, 2}, std::vector<Real>{1}), Error);
  EXPECT_THROW(sim.add_particles(std::vector<Real>{1, 2}, {}, 1), Error);
  EXPECT_THROW(sim.remove_particles(std::vector<std::uint64_t>{0, 1000}), Error);
  EXPECT_THROW(sim.remove_particles(std::vector<std::uint64_t>{0, 0}), Error);
  EXPECT_EQ(sim.state_sha256(), before);
}

TEST(Interventions, ObserversAreCalledAsScheduled) {
  Simulation sim = simulation_of(drop("wcsph"));
  std::vector<std::int64_t> by_steps, by_time;
  sim.observe({.steps = 4}, [&](const Simulation& s) { by_steps.push_back(s.steps_done()); });
  sim.observe({.seconds = 0.002}, [&](const Simulation& s) { by_time.push_back(s.steps_done()); });
  for (int k = 0; k < 10; ++k) sim.step();
  EXPECT_EQ(by_steps, (std::vector<std::int64_t>{1, 5, 9}));
  EXPECT_EQ(by_time, (std::vector<std::int64_t>{1, 4, 8}));
}

}  // namespace
}  // namespace freshet::test

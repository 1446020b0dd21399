// SPDX-License-Identifier: MIT
// Keys that change while a simulation runs, and bodies that are pulled.
#include <gtest/gtest.h>

#include <cmath>

#include "freshet/checkpoint.h"
#include "freshet/scene_keys.h"
#include "freshet/simulation.h"
#include "scene/model/body_shape.h"
#include "sim/forced.h"

namespace freshet {
namespace {

std::string tank(const std::string& solver) {
  return R"(
[domain]
max = [1.0, 1.0]
[particles]
spacing = 0.05
[fluid]
shape = "box"
min = [0.0, 0.0]
max = [0.5, 0.5]
[solver]
name = ")" +
         solver + R"("
[time]
end = 1.0
step = 0.0005
)";
}

constexpr const char* tap = R"(
[domain]
max = [2.0, 1.0]
gravity = [0.0, 0.0]
[particles]
spacing = 0.05
[inlet]
center = [0.3, 0.5]
direction = [1.0, 0.0]
width = 0.4
speed = 1.0
[solver]
name = "wcsph"
sound_speed = 20
[walls]
x_max = "open"
x_min = "open"
[time]
end = 2.0
step = 0.0005
)";

void step(Simulation& sim, int count) {
  for (int k = 0; k < count; ++k) sim.step();
}

TEST(Change, EqualsTheChangedSceneThatResumesFromTheState) {
  for (const char* solver : {"wcsph", "delta_sph", "dfsph", "pbf"}) {
    SCOPED_TRACE(solver);
    if (!test::compiled(solver)) continue;
    const std::vector<Override> change{{"domain.gravity", "[2.0, -3.0]"}};
    Simulation sim(parse_scene(tank(solver), "tank"));
    step(sim, 20);
    Checkpoint state = sim.checkpoint();
    sim.change(change);
    EXPECT_EQ(sim.steps_done(), 20);
    EXPECT_EQ(sim.scene().domain.gravity, (Vector{2, -3}));
    step(sim, 20);
    state.scene.clear();
    Simulation other(parse_scene(tank(solver), "tank", change));
    other.restore(state);
    step(other, 20);
    EXPECT_EQ(sim.state_sha256(), other.state_sha256());
    Simulation unchanged(parse_scene(tank(solver), "tank"));
    step(unchanged, 40);
    EXPECT_NE(sim.state_sha256(), unchanged.state_sha256());
  }
}

TEST(Change, ToTheSameValueChangesNoBit) {
  Simulation sim(parse_scene(tank("dfsph"), "tank")), unchanged(parse_scene(tank("dfsph"), "tank"));
  step(sim, 15);
  sim.change({{"domain.gravity", "[0.0, -9.81]"}});
  step(sim, 15);
  step(unchanged, 30);
  EXPECT_EQ(sim.state_sha256(), unchanged.state_sha256());
}

TEST(Change, OtherKeysAndInvalidValuesAreRejectedAndChangeNothing) {
  Simulation sim(parse_scene(tank("wcsph"), "tank"));
  step(sim, 5);
  const std::string before = sim.kept_sha256();
  EXPECT_THROW(sim.change({{"particles.spacing", "0.04"}}), Error);
  EXPECT_THROW(sim.change({{"solver.name", "\"pbf\""}}), Error);
  EXPECT_THROW(sim.change({{"solver.sound_speed", "-1.0"}}), Error);
  EXPECT_EQ(sim.kept_sha256(), before);
  Scene made;
  made.domain.max = {1, 1};
  made.particles.spacing = 0.1;
  made.fluid.emplace_back();
  made.fluid[0].max = {0.5, 0.5};
  made.fluid[0].min = {0, 0};
  made.fluid[0].shape = Shape::box;
  made.time.end = 1;
  made.time.step = 1e-3;
  Simulation in_code(made);
  EXPECT_THROW(in_code.change({{"domain.gravity", "[0.0, 0.0]"}}), Error);
}

TEST(Change, KeepsObserversForcesAndGravityOfTheCaller) {
  Simulation sim(parse_scene(tank("wcsph"), "tank"));
  int seen = 0;
  sim.observe({}, [&](const Simulation&) { ++seen; });
  sim.set_gravity({0, 0});
  sim.set_force([](const ParticleView& fluid, double, std::span<double> a) {
    for (std::size_t i = 0; i < fluid.size(); ++i) a[2 * i] += 4;
  });
  sim.change({{"solver.sound_speed", "50.0"}});
  step(sim, 20);
  EXPECT_EQ(seen, 20);
  EXPECT_EQ(sim.scene().domain.gravity, (Vector{0, 0}));
  const Statistics s = sim.statistics();
  EXPECT_GT(s.momentum[0], 3 * sim.time() * 250) << "250 kg/m are pushed by 4 m/s²";
  sim.change({{"domain.gravity", "[0.0, -1.0]"}});
  EXPECT_EQ(sim.scene().domain.gravity, (Vector{0, -1}));
}

TEST(Change, InletKeepsItsLayersAndEmitsAtTheNewSpeed) {
  Simulation sim(parse_scene(tap, "tap"));
  const auto passed = [&] { return double(sim.flows()[0].volume); };
  step(sim, 1000);
  const double before = passed();
  EXPECT_NEAR(before, 0.4 * 1.0 * 0.5, 0.021) << "width times speed times 0.5 s";
  const std::size_t particles = sim.fluid().size();
  sim.change({{"inlet[0].speed", "2.0"}});
  EXPECT_EQ(sim.fluid().size(), particles);
  step(sim, 2);
  EXPECT_NEAR(passed(), before, 0.021) << "no burst";
  step(sim, 498);
  EXPECT_NEAR(passed() - before, 0.4 * 2.0 * 0.25, 0.021);
  const double middle = passed();
  sim.change({{"inlet[0].speed", "0.5"}});
  const Checkpoint state = sim.checkpoint();
  step(sim, 500);
  EXPECT_NEAR(passed() - middle, 0.4 * 0.5 * 0.25, 0.021);
  Simulation again(parse_scene(tap, "tap", {{"inlet[0].speed", "0.5"}}));
  again.restore(state);
  step(again, 500);
  EXPECT_EQ(again.state_sha256(), sim.state_sha256());
}

TEST(Change, SceneWithWallsAcceptsLiveKeys) {
  const std::string text = tank("wcsph") + R"(
[[wall]]
shape = "box"
min = [0.7, 0.0]
max = [0.8, 0.2]
[walls]
method = "adami2012"
)";
  const std::vector<Override> changes{{"solver.artificial_viscosity", "0.2"},
                                      {"solver.background_pressure", "10.0"},
                                      {"domain.gravity", "[0.0, -5.0]"}};
  for (const Override& change : changes) {
    SCOPED_TRACE(change.first);
    Simulation sim(parse_scene(text, "tank"));
    step(sim, 10);
    EXPECT_NO_THROW(sim.change({change}));
    step(sim, 10);
    EXPECT_EQ(sim.steps_done(), 20);
  }
}

TEST(Change, PulledBodyMovesByNewtonsLaw) {
  if (!moves_free_bodies()) GTEST_SKIP() << "Bullet is not installed: no body is free";
  constexpr const char* afloat = R"(
[domain]
max = [2.0, 2.0]
gravity = [0.0, 0.0]
[particles]
spacing = 0.1
[fluid]
shape = "box"
min = [0.1, 0.1]
max = [0.3, 0.3]
[[body]]
shape = "box"
min = [1.0, 1.0]
max = [1.2, 1.2]
motion = "free"
density = 500.0
[solver]
name = "wcsph"
sound_speed = 10
[time]
end = 1.0
step = 0.001
)";
  Simulation sim(parse_scene(afloat, "afloat"));
  const double mass = 500 * 0.04;
  sim.push_body(0, {mass * 3, 0, 7}, {9, 9, 0});
  step(sim, 50);
  EXPECT_NEAR(sim.bodies()[0].velocity[0], 3 * 0.05, 1e-6);
  EXPECT_NEAR(sim.bodies()[0].velocity[2], 0, 1e-12) << "a slice stays in its plane";
  EXPECT_NEAR(sim.bodies()[0].angular_velocity[2], 0, 1e-9);
  sim.change({{"solver.sound_speed", "12.0"}});
  step(sim, 10);
  EXPECT_NEAR(sim.bodies()[0].velocity[0], 3 * 0.06, 1e-6) << "a change keeps the pull";
  sim.push_body(0, {});
  step(sim, 10);
  EXPECT_NEAR(sim.bodies()[0].velocity[0], 3 * 0.06, 1e-6);
  EXPECT_THROW(sim.push_body(1, {}), Error);
  EXPECT_THROW(sim.push_body(0, {NAN, 0, 0}), Error);
}

TEST(SceneKeys, ListHasTheValuesOfTheSceneAndWhatMayChange) {
  const Scene scene = parse_scene(tank("wcsph"), "tank");
  const auto keys = keys_of(scene);
  const auto find = [&](const std::string& path) -> const SceneKey& {
    for (const SceneKey& key : keys)
      if (key.path == path) return key;
    ADD_FAILURE() << path << " is missing";
    return keys.front();
  };
  EXPECT_EQ(find("particles.spacing").value, "0.05");
  EXPECT_TRUE(find("particles.spacing").is_set);
  EXPECT_FALSE(find("particles.spacing").live);
  EXPECT_EQ(find("domain.gravity").value, "[0, -9.81]");
  EXPECT_FALSE(find("domain.gravity").is_set);
  EXPECT_TRUE(find("domain.gravity").live);
  EXPECT_EQ(find("fluid[0].max").kind, SceneKey::Kind::numbers);
  EXPECT_EQ(find("solver.name").words.size(), 7u);
  EXPECT_EQ(find("solver.name").value, "\"wcsph\"");
  for (const SceneKey& key : keys) EXPECT_NE(key.path, "solver.xsph") << "of other solvers";
  for (const SceneKey& key : keys) {
    EXPECT_FALSE(key.text.empty()) << key.path;
    if (!key.live || key.value.empty() || key.kind == SceneKey::Kind::other) continue;
    EXPECT_NO_THROW(parse_scene(tank("wcsph"), "tank", {{key.path, key.value}})) << key.path;
  }
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "run/frame_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

Scene periodic_scene() {
  return parse_scene(
      "[domain]\nmax = [1, 1]\nperiodic = \"x\"\n[particles]\nspacing = 0.1\n[fluid]\nmin = [0, "
      "0]\n"
      "max = [1, 0.5]\n[solver]\nname = \"wcsph\"\n[time]\nend = 1\nstep = 0.001\n",
      "test.toml");
}

Frame frame_of(double time, std::vector<std::uint64_t> id, std::vector<float> x,
               std::vector<float> v) {
  Frame f;
  f.step = 1 + std::int64_t(time);
  f.time = time;
  f.id = std::move(id);
  f.x = std::move(x);
  f.v = std::move(v);
  f.density.assign(f.id.size(), float(1000 + time));
  f.pressure.assign(f.id.size(), float(time));
  return f;
}

/// x = 0.2 + 0.1 t + 0.05 t² - 0.02 t³ is met exactly.
TEST(FrameBetween, InterpolatesACubicExactly) {
  const auto x = [](double t) { return 0.2 + 0.1 * t + 0.05 * t * t - 0.02 * t * t * t; };
  const auto v = [](double t) { return 0.1 + 0.1 * t - 0.06 * t * t; };
  const auto at = [&](double t) { return frame_of(t, {7}, {float(x(t)), 0.5f}, {float(v(t)), 0}); };
  const Frame f = frame_between(at(1), at(2), 1.3, periodic_scene());
  EXPECT_NEAR(x(1.3), f.x[0], 1e-6);
  EXPECT_NEAR(0.7 * v(1) + 0.3 * v(2), f.v[0], 1e-6);
  EXPECT_NEAR(1001.3, f.density[0], 1e-4);
  EXPECT_NEAR(1.3, f.pressure[0], 1e-6);
  EXPECT_EQ(1.3, f.time);
  EXPECT_EQ(3, f.step);
}

TEST(FrameBetween, CrossesAPeriodicEnd) {
  const Frame a = frame_of(1, {0}, {0.95f, 0.5f}, {0.1f, 0}),
              b = frame_of(2, {0}, {0.05f, 0.5f}, {0.1f, 0});
  EXPECT_NEAR(0.975, frame_between(a, b, 1.25, periodic_scene()).x[0], 1e-6);
  EXPECT_NEAR(0.025, frame_between(a, b, 1.75, periodic_scene()).x[0], 1e-6);
}

/// Particle 1 leaves, particle 2 enters.
TEST(FrameBetween, HasEachParticleOfTheNearerFrame) {
  const Frame a = frame_of(1, {0, 1}, {0.1f, 0.1f, 0.2f, 0.2f}, {0, 0, 0.1f, 0}),
              b = frame_of(2, {0, 2}, {0.1f, 0.1f, 0.3f, 0.3f}, {0, 0, 0, 0.1f});
  const Frame early = frame_between(a, b, 1.25, periodic_scene()),
              late = frame_between(a, b, 1.75, periodic_scene());
  EXPECT_EQ((std::vector<std::uint64_t>{0, 1}), early.id);
  EXPECT_NEAR(0.225, early.x[2], 1e-6);
  EXPECT_EQ((std::vector<std::uint64_t>{0, 2}), late.id);
  EXPECT_NEAR(0.275, late.x[3], 1e-6);
}

TEST(FrameBetween, TurnsBodies) {
  Frame a = frame_of(1, {}, {}, {}), b = frame_of(2, {}, {}, {});
  BodyState body;
  body.velocity = {0.4, 0, 0};
  a.bodies = {body};
  body.position = {0.4, 0, 0};
  body.orientation = {0, 0, -std::sin(0.2), -std::cos(0.2)};  // turned by 0.4 rad
  b.bodies = {body};
  const BodyState half = frame_between(a, b, 1.5, periodic_scene()).bodies[0];
  EXPECT_NEAR(0.2, half.position[0], 1e-12);
  EXPECT_NEAR(std::sin(0.1) / std::cos(0.1), half.orientation[2] / half.orientation[3], 1e-12);
}

TEST(FrameSource, ShowsTheStartTheEndAndTimesWithinAStep) {
  Simulation sim(periodic_scene());
  FrameSource frames(sim);
  const Frame start = sim.frame();
  frames.before_step(true);
  sim.step();
  const Frame end = sim.frame();
  EXPECT_EQ(start.x, frames.at(0)->x);
  EXPECT_EQ(end.density, frames.at(0)->density);  // the start has none yet
  EXPECT_EQ(end.x, frames.at(sim.time())->x);
  EXPECT_EQ(0.0004, frames.at(0.0004)->time);
  EXPECT_EQ(frames.at(0.0004), frames.at(0.0004));
}

}  // namespace
}  // namespace freshet::test

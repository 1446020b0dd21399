// SPDX-License-Identifier: MIT
// The health monitor on artificial particles: each rule just below and just above its bounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "io/checkpoint.h"
#include "sim/pool.h"

namespace freshet::test {
namespace {

TEST(Health, ChecksOftenAtFirst) {
  std::vector<std::int64_t> steps;
  for (std::int64_t k = 1; k <= 300; ++k)
    if (Health::due(k)) steps.push_back(k);
  EXPECT_EQ((std::vector<std::int64_t>{1, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 200, 300}),
            steps);
}

TEST(Health, ValidFluidGivesNoWarning) {
  Pool pool;
  for (const std::int64_t step : {10, 20, 100}) pool.look(step);
  EXPECT_TRUE(pool.warnings().empty());
}

TEST(Health, NanEndsTheRunEvenIfWhenWrongIsWarn) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const std::string& more : {std::string(), warn}) {
    Pool in_x(more), in_v(more), in_density(more);
    in_x.x[2 * 50] = in_x.x[2 * 7 + 1] = nan;
    in_v.v[2 * 7] = std::numeric_limits<Real>::infinity();
    in_density.density[7] = nan;
    for (Pool* pool : {&in_x, &in_v, &in_density}) {
      const std::string failure = pool->failure(10);
      EXPECT_TRUE(failure.starts_with("error: particle 7 is no number any more, at (")) << failure;
      EXPECT_TRUE(contains(failure, "at step 10, 0.005 s (at step 1 the fastest, particle "))
          << failure;
    }
  }
}

TEST(Health, NamesTheFastestOfTheLastCheckAfterARestart) {
  Pool pool;
  pool.v[2 * 42] = 25;
  pool.look(10);
  Checkpoint checkpoint;
  checkpoint.watch = pool.record();
  pool.x[0] = Real(15.2);
  const std::string whole = pool.failure(20);
  EXPECT_TRUE(contains(whole, "(at step 10 the fastest, particle 42 at (")) << whole;
  pool.go_on(decode_checkpoint(encode_checkpoint(checkpoint), "step.h5").watch);
  EXPECT_EQ(whole, pool.failure(20));
}

TEST(Health, CountsTheSameStepsAfterARestart) {
  Pool whole, resumed;
  for (Pool* pool : {&whole, &resumed}) pool->look(100);
  resumed.go_on(resumed.record());  // at step 150, say, between two checks
  for (Pool* pool : {&whole, &resumed}) pool->look(200);
  EXPECT_EQ(200, whole.record().steps_watched);
  EXPECT_EQ(200, resumed.record().steps_watched);
}

TEST(Health, ParticleFarBeyondAWallEndsTheRun) {
  Pool near, far, gone("[walls]\nx_max = \"open\"\n"), above("[walls]\nx_max = \"open\"\n");
  near.x[0] = 15;  // ten diagonals are 14.1 m
  far.x[0] = gone.x[0] = Real(15.2);
  gone.x[1] = -20;  // it left through the open side and fell
  above.x[1] = Real(15.2);
  EXPECT_EQ("", near.failure(10));
  EXPECT_TRUE(far.failure(10).starts_with("error: particle 0 is lost, at (15.2, "))
      << far.failure(20);
  EXPECT_EQ("", gone.failure(10));
  EXPECT_TRUE(gone.warnings().empty());
  EXPECT_TRUE(above.failure(10).starts_with("error: particle 0 is lost, at (0.025, 15.2)"))
      << above.failure(20);
}

TEST(Health, CountsParticlesThatWentThroughWalls) {
  Pool pool;
  pool.x[2 * 9] = Real(1.11);  // the support radius is 0.1 m
  pool.look(10);
  EXPECT_EQ("walls", pool.warning().kind);
  EXPECT_TRUE(pool.warning().message.starts_with(
      "1 of 100 particles went through walls that should hold them, the first of them particle 9 "
      "at (1.11, "))
      << pool.warning().message;
  EXPECT_FALSE(pool.warning().cannot_be_right);  // up to 1 % may be strays
  pool.x[2 * 8 + 1] = Real(-0.11);
  EXPECT_EQ("", pool.failure(20));
  EXPECT_TRUE(pool.warning().cannot_be_right);
  EXPECT_EQ(0.02, pool.warning().worst);
  Pool wet, open("[walls]\nmethod = \"open\"\n");
  wet.x[0] = Real(1.09);
  open.x[0] = Real(1.11);
  wet.look(10);
  open.look(10);
  EXPECT_TRUE(wet.warnings().empty());
  EXPECT_TRUE(open.warnings().empty());
}

TEST(Health, WarnsOfAParticleInAWall) {
  Pool pool("[[wall]]\nshape = \"box\"\nmin = [0.6, 0.2]\nmax = [0.9, 0.8]\n");
  pool.x[2 * 9] = Real(0.69);
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  pool.x[2 * 9] = Real(0.72);
  pool.x[2 * 9 + 1] = Real(0.5);
  pool.look(20);
  EXPECT_EQ("walls", pool.warning().kind);
}

TEST(Health, LongTimeStepGivesAWarningOnly) {
  Pool pool;
  pool.bounds = {0.0005 / 1.24, 1, 1};
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  pool.bounds = {1, 0.0005 / 100, 1};
  for (std::int64_t step = 20; step <= 100; step += 10) EXPECT_EQ("", pool.failure(step));
  EXPECT_EQ("time step", pool.warning().kind);
  EXPECT_TRUE(contains(pool.warning().message, "time.step, 0.0005 s, is 100 times the longest"));
  EXPECT_TRUE(contains(pool.warning().message, "by the bound of force"));
  EXPECT_FALSE(pool.warning().cannot_be_right);  // a step over its limit can succeed
  Pool adaptive("", "gravity = [0, 0]\n", "step = \"adaptive\"\nstep_max = 0.01\n");
  adaptive.bounds = pool.bounds;
  adaptive.look(10);
  EXPECT_TRUE(adaptive.warnings().empty());
}

TEST(Health, ChecksThePositiveDensityError) {
  Pool pool;
  for (Real& rho : pool.density) rho = 1099;
  for (std::size_t k = 0; k < 50; ++k) pool.density[k] = 500;  // as at a surface: no error
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  for (Real& rho : pool.density) rho = 1110;
  pool.density[17] = 1500;
  pool.look(20);
  EXPECT_EQ("density", pool.warning().kind);
  EXPECT_TRUE(
      contains(pool.warning().message, "11.4 % denser than at rest on average, particle 17"))
      << pool.warning().message;
  for (Real& rho : pool.density) rho = 1999;
  EXPECT_EQ("", pool.failure(30));
  for (Real& rho : pool.density) rho = 2001;
  EXPECT_TRUE(pool.failure(40).starts_with(
      "error: the run cannot be right: the fluid is 100 % denser than at rest on average"))
      << pool.failure(50);
}

TEST(Health, RunIsUnphysicalIfAWarningLasts) {
  Pool pool;
  const auto set = [&](Real rho) { pool.density.assign(pool.density.size(), rho); };
  set(1200);
  for (std::int64_t step = 10; step <= 50; step += 10) pool.look(step);
  EXPECT_TRUE(pool.warning().cannot_be_right);  // steps 1 to 50 of 50
  EXPECT_EQ(5, pool.warning().looks);
  EXPECT_EQ(10, pool.warning().first_step);
  EXPECT_DOUBLE_EQ(0.005, pool.warning().first_time);
  set(1000);
  for (std::int64_t step = 60; step <= 90; step += 10) pool.look(step);
  EXPECT_TRUE(pool.warning().cannot_be_right);  // 49 of 90
  pool.look(100);
  EXPECT_FALSE(pool.warning().cannot_be_right);
  EXPECT_EQ(5, pool.warning().looks);
  EXPECT_EQ(50, pool.warning().last_step);
}

TEST(Health, ContinuesIfWhenWrongIsWarn) {
  Pool pool(warn);
  pool.density.assign(pool.density.size(), 2500);
  EXPECT_EQ("", pool.failure(10));
  pool.density.assign(pool.density.size(), 1000);
  for (std::int64_t step = 20; step <= 100; step += 10) EXPECT_EQ("", pool.failure(step));
  EXPECT_TRUE(pool.warning().cannot_be_right);  // one check beyond the fatal bound is enough
  EXPECT_DOUBLE_EQ(1.5, pool.warning().worst);
}

TEST(Health, ComparesRelativeSpeedsWithSound) {
  Pool pool;  // all particles move alike, at twice the speed of sound
  EXPECT_TRUE(pool.warnings().empty());
  shake(pool, Real(2.9));
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  shake(pool, Real(3.1));
  pool.look(20);
  EXPECT_EQ("speed", pool.warning().kind);
  EXPECT_NEAR(0.31, pool.warning().worst, 1e-6);
  EXPECT_TRUE(contains(pool.warning().message, "make solver.sound_speed at least 200"))
      << pool.warning().message;
  shake(pool, Real(9.9));
  EXPECT_EQ("", pool.failure(30));
  shake(pool, Real(10.1));
  EXPECT_TRUE(
      pool.failure(40).starts_with("error: the run cannot be right: the particles move at "
                                   "10.1 m/s"))
      << pool.failure(50);
}

TEST(Health, WarnsOfAParticleFasterThanSound) {
  Pool pool;
  shake(pool, 1);
  pool.v[2 * 33 + 1] = Real(9.8);
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  pool.v[2 * 33 + 1] = Real(10.2);
  pool.look(20);
  EXPECT_EQ("fastest particle", pool.warning().kind);
  EXPECT_TRUE(contains(pool.warning().message, "the fastest, particle 33 at ("))
      << "the message must name particle 33";
}

TEST(Health, NamesTheSameParticlesInAnyOrder) {
  const auto message = [](bool turned) {
    Pool pool;
    if (turned) {
      std::reverse(pool.id.begin(), pool.id.end());
      for (std::size_t k = 0; k < 50; ++k)
        for (std::size_t d = 0; d < 2; ++d) std::swap(pool.x[2 * k + d], pool.x[2 * (99 - k) + d]);
    }
    pool.density.assign(100, 1300);  // all particles have the maximum density and speed
    shake(pool, 4);
    pool.look(10);
    EXPECT_EQ(2u, pool.warnings().size());
    return pool.warnings()[0].message + "\n" + pool.warnings()[1].message;
  };
  EXPECT_EQ(message(false), message(true));
  for (const char* words : {"average, particle 0 at (0.025, 0.025)",
                            "the fastest, particle 0 at (0.025, 0.025), has 4 m/s"})
    EXPECT_TRUE(contains(message(true), words)) << message(true);
}

TEST(Health, ChecksTheEnergyPerMass) {
  Pool pool;                                 // 200 J/kg at the start
  pool.v.assign(pool.v.size(), Real(17.3));  // 299 J/kg
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  pool.v.assign(pool.v.size(), Real(17.4));  // 303 J/kg
  pool.look(20);
  EXPECT_EQ("energy", pool.warning().kind);
  EXPECT_NEAR(0.51, pool.warning().worst, 0.01);
  pool.v.assign(pool.v.size(), Real(46.8));
  EXPECT_EQ("", pool.failure(30));
  pool.v.assign(pool.v.size(), 47);
  EXPECT_TRUE(contains(pool.failure(40), " J/kg of energy came from nowhere")) << pool.failure(50);
}

TEST(Health, EnergyCheckIncludesTheWorkOfGravity) {
  const Real fast = 30;  // 900 J/kg; the start has 200 J/kg
  for (const char* domain : {"gravity = [0, -1000]\n", "gravity = [0, 0]\n"}) {
    Pool falling(warn, domain);  // sound is too slow for the stronger gravity
    falling.v.assign(falling.v.size(), fast);
    for (std::size_t k = 0; k < 100; ++k) falling.x[2 * k + 1] -= Real(0.7);  // into the floor
    falling.look(10);
    const auto& all = falling.warnings();
    EXPECT_EQ(domain[14] == '0', std::any_of(all.begin(), all.end(),
                                             [](const Warning& w) { return w.kind == "energy"; }))
        << domain;
  }
  Pool endless("", "gravity = [1, 0]\nperiodic = \"x\"\n");  // unlimited work of gravity
  endless.v.assign(endless.v.size(), 50);
  endless.look(10);
  EXPECT_TRUE(endless.warnings().empty());
}

TEST(Health, NamesTheLikeliestCause) {
  Pool close;
  const auto cause = [](Pool& pool) {
    pool.density.assign(100, 2500);
    return pool.failure(10);
  };
  EXPECT_TRUE(contains(cause(close), "make solver.sound_speed at least 200"))
      << "faster than sound";
  Pool step("", "gravity = [0, 0]\n", "step = 0.02\n");
  EXPECT_TRUE(contains(cause(step), "time.step, 0.02 s, is over its bound, ")) << cause(step);
  Pool overlapping;
  overlapping.density.assign(100, 1600);
  overlapping.begin_again();
  EXPECT_TRUE(contains(cause(overlapping),
                       "particle 0 at (0.025, 0.025) had 1.6 times its rest "
                       "density at step 1: particles start too close"))
      << cause(overlapping);
}

TEST(Health, DoesNotWarnOfTheArticle) {
  const Scene scene = with_defaults(load_scene(SOURCE_DIR "/scenes/article.toml"));
  Simulation sim(scene);
  for (int k = 0; k < 100; ++k) sim.step();
  EXPECT_GT(sim.statistics().density_mean, 1.5 * scene.fluid[0].rest_density);
  EXPECT_TRUE(sim.warnings().empty());
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// The health monitor with pressure solvers: their solves, and messages without sound.
#include <gtest/gtest.h>

#include <limits>

#include "freshet/real.h"
#include "io/checkpoint.h"
#include "scene/model/expressions.h"
#include "sim/pool.h"

namespace freshet::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* weightless = "gravity = [0, 0]\n";
constexpr const char* fixed = "step = 0.0005\n";

/// The fluid moves at 20 m/s, so the nominal speed of sound is 200 m/s.
struct PressurePool : Pool {
  explicit PressurePool(const std::string& solver, const std::string& step = fixed)
      : Pool("", weightless, step, "velocity = [20, 0]\n[solver]\nname = \"" + solver + "\"\n") {
    solves.resize(1);
    solves[0].name = "density";
    solves[0].tolerance = 1e-4;
  }
};

/// Adds `count` solves that did not converge.
void fail(SolveStatistics& s, std::int64_t count, double error, std::int64_t iterations = 100) {
  s.solves += count;
  s.not_converged += count;
  s.most_iterations = std::max(s.most_iterations, iterations);
  s.worst_error = std::max(s.worst_error, error);
  s.last_iterations = iterations;
  s.last_error = error;
}

TEST(HealthOfPressureSolvers, SolvesThatDidNotConvergeGiveOneWarning) {
  PressurePool pool("dfsph");
  pool.solves.resize(2);
  pool.solves[1].name = "divergence";
  pool.solves[1].tolerance = 1e-3;
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
  fail(pool.solves[1], 3, 0.0025);
  EXPECT_EQ("", pool.failure(20));
  EXPECT_EQ("pressure solve", pool.warning().kind);
  EXPECT_EQ(
      "a divergence solve did not converge: after 100 iterations its error was 0.25 %, and "
      "solver.divergence_tolerance is 0.1 %, at step 20, 0.01 s; make solver.max_iterations or "
      "solver.divergence_tolerance larger, or time.step smaller",
      pool.warning().message);
  EXPECT_DOUBLE_EQ(2.5, pool.warning().worst);
  pool.look(30);
  EXPECT_EQ(1, pool.warning().looks);  // no new solve
  fail(pool.solves[0], 1, 0.1);
  pool.look(40);
  EXPECT_EQ(2, pool.warning().looks);
  EXPECT_EQ(1000, pool.warning().worst);
  EXPECT_FALSE(pool.warning().cannot_be_right);  // 4 of 40 steps
}

TEST(HealthOfPressureSolvers, CountsNoSolveTwiceAfterARestart) {
  PressurePool pool("dfsph");
  fail(pool.solves[0], 3, 0.01);
  pool.look(10);
  Checkpoint before;
  before.watch = pool.record();
  pool.go_on(decode_checkpoint(encode_checkpoint(before), "step.h5").watch);
  pool.look(20);
  EXPECT_EQ(1, pool.warning().looks);
  fail(pool.solves[0], 1, 0.01);
  pool.look(30);
  EXPECT_EQ(2, pool.warning().looks);
}

TEST(HealthOfPressureSolvers, WarnsOfASolveBetweenChecks) {
  PressurePool pool("iisph");
  fail(pool.solves[0], 1, 0.02, 77);
  pool.solves[0].last_iterations = 5;
  pool.solves[0].last_error = 0.00005;  // the next step converged
  pool.look(10);
  EXPECT_TRUE(contains(pool.warning().message,
                       "after 77 iterations its error was 2 %, and solver.density_tolerance is "
                       "0.01 %, before or at step 10, 0.005 s; "))
      << pool.warning().message;
}

TEST(HealthOfPressureSolvers, RunIsUnphysicalIfMostStepsDoNotConverge) {
  PressurePool most("pbf"), few("pbf");
  for (std::int64_t step = 10; step <= 100; step += 10) {
    fail(most.solves[0], 12, 0.01);  // halved steps can fail more often than there are steps
    fail(few.solves[0], 4, 0.01);
    EXPECT_EQ("", most.failure(step));
    few.look(step);
  }
  EXPECT_TRUE(most.warning().cannot_be_right);
  EXPECT_FALSE(few.warning().cannot_be_right);
  for (std::int64_t step = 110; step <= 200; step += 10) most.look(step);
  EXPECT_FALSE(most.warning().cannot_be_right);  // 99 of 200
}

TEST(HealthOfPressureSolvers, NamesTheRemedyForASolve) {
  const auto message = [](Pool& pool, double error) {
    fail(pool.solves[0], 1, error);
    pool.look(10);
    return pool.warnings().back().message;
  };
  PressurePool fast("pcisph");
  fast.bounds = {infinity, 1, 1, 0.0003};
  EXPECT_TRUE(contains(message(fast, 0.01),
                       "the time step, 0.0005 s, is too long for this flow, 0.0003 s are its "
                       "bound; make time.step smaller"));
  PressurePool adaptive("pcisph", "step = \"adaptive\"\nstep_max = 0.01\n");
  adaptive.bounds = {infinity, 1, 1, 0.0003};
  EXPECT_TRUE(contains(message(adaptive, 0.01), "make time.step_max smaller"));
  PressurePool alone("pcisph", "step = 0.0005\nretry = false\n");
  EXPECT_TRUE(contains(message(alone, 0.01), "or time.step smaller, or set time.retry = true"));
  PressurePool close("pcisph");
  close.density.assign(100, 1600);
  close.begin_again();
  EXPECT_TRUE(contains(message(close, 0.01), "particles start too close"));
}

TEST(HealthOfPressureSolvers, ReportsAnErrorBelowThePrecisionOf32BitNumbers) {
  const auto message = [](double tolerance, double error, std::int64_t iterations) {
    PressurePool pool("dfsph");
    pool.solves[0].tolerance = tolerance;
    fail(pool.solves[0], 1, error, iterations);
    pool.look(10);
    return pool.warning().message;
  };
  const bool coarse = sizeof(Real) == sizeof(float);
  const char* words = "32-bit numbers do not tell so small an error";
  EXPECT_EQ(coarse, contains(message(1e-6, 3e-6, 100), words)) << message(1e-6, 3e-6, 100);
  EXPECT_EQ(coarse, contains(message(1e-6, 3e-5, 40), words));  // the solve gave up early
  EXPECT_FALSE(contains(message(1e-6, 3e-5, 100), words));
  EXPECT_FALSE(contains(message(2e-5, 3e-5, 40), words));
}

/// Expects a message with this part that mentions neither sound nor stiffness.
void expect_no_sound(const std::string& message, const std::string& part) {
  EXPECT_TRUE(contains(message, part)) << message;
  EXPECT_FALSE(contains(message, "sound")) << message;
  EXPECT_FALSE(contains(message, "stiffness")) << message;
}

TEST(HealthOfPressureSolvers, MessagesDoNotMentionSound) {
  PressurePool dense("iisph");
  dense.density.assign(100, 1200);
  dense.look(10);
  expect_no_sound(dense.warning().message,
                  "make time.step or solver.density_tolerance smaller, or solver.max_iterations "
                  "larger");
  PressurePool moved("iisph"), one("iisph");
  shake(moved, 59);
  moved.look(10);
  ASSERT_EQ(1u, moved.warnings().size());
  EXPECT_EQ("energy", moved.warnings()[0].kind);
  shake(moved, 61);
  moved.look(20);
  ASSERT_EQ(2u, moved.warnings().size());
  EXPECT_EQ("speed", moved.warnings()[1].kind);
  expect_no_sound(moved.warnings()[1].message,
                  ", 3.05 times the speed of the start or a fall through the domain, at step 20");
  one.v[2 * 42] = 230;
  one.look(10);
  EXPECT_EQ("fastest particle", one.warnings().at(0).kind);
  expect_no_sound(one.warnings()[0].message,
                  "times as fast as the start or a fall through the domain, at step 10");
  one.v.assign(one.v.size(), 1000);
  expect_no_sound(one.failure(20), " J/kg of energy came from nowhere");
}

/// The fluid of PressurePool, and a body that moves along x by this function of time.
Pool with_moved_body(const std::string& x) {
  return Pool("[[body]]\nmin = [0.6, 0.2]\nmax = [0.8, 0.4]\nmotion = \"moved\"\nposition = [\"" +
                  x + "\", \"0\"]\n",
              weightless, fixed, "velocity = [20, 0]\n[solver]\nname = \"iisph\"\n");
}

TEST(HealthOfPressureSolvers, ComparesWithTheFastestMovedBody) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  Pool slow = with_moved_body("0.01*t");
  shake(slow, 59);
  slow.look(10);
  EXPECT_EQ("energy", slow.warning().kind);        // as without the body
  Pool fast = with_moved_body("0.01*sin(1e4*t)");  // 102 m/s at most
  shake(fast, 290);
  fast.look(10);
  EXPECT_TRUE(fast.warnings().empty());
  shake(fast, 310);
  fast.look(20);
  EXPECT_EQ("speed", fast.warning().kind);
  EXPECT_TRUE(contains(fast.warning().message, " times the speed of the fastest solid, "))
      << fast.warning().message;
  shake(fast, 600);
  fast.look(30);
  EXPECT_EQ("energy", fast.warnings().at(1).kind);
}

TEST(HealthOfPressureSolvers, NamesTheCauseOfAVanishingStep) {
  Pool thick("", weightless, "step = \"adaptive\"\nstep_max = 0.01\n",
             "viscosity = 1e12\n[solver]\nname = \"dfsph\"\n");
  thick.bounds = {infinity, infinity, 1e-12};
  expect_no_sound(thick.step_failure(),
                  "by the bound of viscosity, at step 10, 0.005 s; fluid.viscosity asks for it");
  Pool fast("", weightless, "step = \"adaptive\"\nstep_max = 0.01\n",
            "velocity = [1e12, 0]\n[solver]\nname = \"dfsph\"\n");
  fast.bounds = {infinity, infinity, infinity, 1e-12};
  expect_no_sound(fast.step_failure(),
                  "by the bound of flow, at step 10, 0.005 s; fluid.velocity asks for it");
}

TEST(HealthOfPressureSolvers, DoesNotCheckSpeedsWithoutANominalSpeed) {
  Pool pool("", weightless, fixed, "[solver]\nname = \"pbf\"\n");
  shake(pool, Real(0.1));  // speed of a lattice that settles
  pool.look(10);
  EXPECT_TRUE(pool.warnings().empty());
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/free_patch.h"

namespace freshet {
namespace {

static_assert(sizeof(Real) == 8,
              "rounding errors of float would hide the errors that are measured here");

constexpr double end = 0.1;  // [s]; sound crosses the patch in this time
constexpr int coarsest = 25, finest = 400;

/// The patch after this number of steps. With `half_step_early`, the initial velocities are those
/// of half a step earlier.
FreePatch after(int steps, bool article, bool half_step_early = false, Real mu = 0.1) {
  auto c = mueller2003_patch<2>(Integrator::leapfrog);
  c.article = article;
  c.mu = mu;
  const Real dt = end / steps;
  FreePatch patch({c});
  if (half_step_early) {
    FreePatch start({c});
    start.run(0, 1);  // a step of length 0 leaves the initial accelerations
    for (int i = 0; i < patch.fluid.n; ++i) patch.fluid.v[i] += -dt / 2 * start.fluid.a[i];
  }
  patch.run(dt, steps);
  return patch;
}

double distance(const FreePatch& a, const FreePatch& b) {
  double sum = 0;
  for (int i = 0; i < a.fluid.n; ++i) sum += norm2(a.fluid.x[i] - b.fluid.x[i]);
  return std::sqrt(sum / a.fluid.n);
}

/// The slope of the line through log(error) over log(step), by least squares.
template <class Run> double order(const Run& run, const FreePatch& truth) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (int steps = coarsest; steps <= finest; steps *= 2) {
    const double log_step = std::log(end / steps);
    const double log_error = std::log(distance(run(steps), truth));
    n += 1;
    x += log_step;
    y += log_error;
    xx += log_step * log_step;
    xy += log_step * log_error;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

const FreePatch& truth() {
  static const FreePatch patch = after(16 * finest, false);
  return patch;
}

// Measured order: 1.01; the error falls from 7.9 mm to 0.48 mm over 4 halvings of the step.
TEST(ArticleIntegrator, OneKickAndOneDriftAreOfFirstOrder) {
  const double slope = order([](int n) { return after(n, true); }, truth());
  EXPECT_NEAR(1, slope, 0.1);
}

// Measured order: 2.05; the error falls from 0.68 mm to 0.0023 mm over 4 halvings of the step.
TEST(ArticleIntegrator, KickDriftKickIsOfSecondOrder) {
  const double slope = order([](int n) { return after(n, false); }, truth());
  EXPECT_NEAR(2, slope, 0.1);
}

// With initial velocities half a step earlier than the positions, the article's loop is leapfrog.
// Viscosity is 0, since it needs velocities at the time of the positions. Measured order: 2.01.
TEST(ArticleIntegrator, OneKickAndOneDriftAreLeapfrogFromAHalfStepStart) {
  const FreePatch inviscid = after(16 * finest, false, false, 0);
  const double slope = order([](int n) { return after(n, true, true, 0); }, inviscid);
  EXPECT_NEAR(2, slope, 0.1);
}

}  // namespace
}  // namespace freshet

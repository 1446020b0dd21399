// SPDX-License-Identifier: MIT
// Convergence order in the time step of each integrator with each solver, on a free patch of fluid.
#include <gtest/gtest.h>

#include "kernels/wendland.h"
#include "solvers/patch.h"

namespace freshet {
namespace {

constexpr double end = 0.1;  // [s]; sound crosses the patch in this time
constexpr int coarsest = 50, finest = 400;

template <class Solver> auto after(const Solver& solver, int steps) {
  Patch<2, Solver> patch(solver);
  patch.run(end / steps, steps);
  return patch;
}

/// The slope of the line through log(error) over log(step), by least squares.
template <class Make> double order(Integrator integrator, const Make& make) {
  const auto truth = after(make(Integrator::leapfrog), 16 * finest);
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (int steps = coarsest; steps <= finest; steps *= 2) {
    const auto patch = after(make(integrator), steps);
    double sum = 0;
    for (int i = 0; i < patch.fluid.n; ++i) sum += norm2(patch.fluid.x[i] - truth.fluid.x[i]);
    const double log_step = std::log(end / steps), log_error = std::log(std::sqrt(sum));
    n += 1;
    x += log_step;
    y += log_error;
    xx += log_step * log_step;
    xy += log_step * log_error;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

using Backend2 = ReferenceBackend<2>;
auto mueller2003(Integrator integrator) {
  return Mueller2003<2, Backend2>{mueller2003_patch<2>(integrator)};
}
auto wcsph(Integrator integrator) {
  auto c = weakly_compressible_patch<2>(integrator);
  c.rho0 = Real(0.25);  // pressure is positive everywhere: the cut-off at 0 is not smooth
  c.c0 = Real(0.1);     // sound has 10 m/s at this compression
  c.alpha = 0;          // artificial viscosity is not smooth where particles begin to approach
  return Wcsph<2, Backend2, WendlandC2>{c, WendlandC2<2>(c.support)};
}
auto delta_sph(Integrator integrator) {
  auto c = weakly_compressible_patch<2>(integrator);
  c.antuono = true;
  return DeltaSph<2, Backend2, WendlandC2>{c, WendlandC2<2>(c.support)};
}

TEST(SymplecticEuler, IsOfFirstOrder) {
  EXPECT_NEAR(1, order(Integrator::symplectic_euler, mueller2003), 0.1);
  EXPECT_NEAR(1, order(Integrator::symplectic_euler, wcsph), 0.1);
  EXPECT_NEAR(1, order(Integrator::symplectic_euler, delta_sph), 0.1);
}
TEST(Leapfrog, IsOfSecondOrder) {
  EXPECT_NEAR(2, order(Integrator::leapfrog, mueller2003), 0.1);
  EXPECT_NEAR(2, order(Integrator::leapfrog, wcsph), 0.1);
  EXPECT_NEAR(2, order(Integrator::leapfrog, delta_sph), 0.1);
}
TEST(Verlet, IsOfSecondOrder) {
  EXPECT_NEAR(2, order(Integrator::verlet, mueller2003), 0.15);
  EXPECT_NEAR(2, order(Integrator::verlet, wcsph), 0.15);
  EXPECT_NEAR(2, order(Integrator::verlet, delta_sph), 0.15);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// Pair forces are equal and opposite, so a free patch of fluid conserves its momentum.
#include <gtest/gtest.h>

#include <random>

#include "kernels/cubic_spline.h"
#include "kernels/wendland.h"
#include "solvers/patch.h"

namespace freshet {
namespace {

template <int D, class Set> Vec<D, double> momentum(const Set& f, double m) {
  Vec<D, double> sum{};
  for (int i = 0; i < f.n; ++i) {
    Vec<D> v = f.v[i];
    for (int d = 0; d < D; ++d) component(sum, d) += m * double(component(v, d));
  }
  return sum;
}

/// The change of momentum relative to sum m|v| + sum over steps of dt sum m|a|.
template <int D, class Solver> double drift(Solver solver) {
  const double dt = 2e-4;
  const double m = double(solver.c.m);
  Patch<D, Solver> patch(solver);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> any(-1, 1);
  auto& f = patch.fluid;
  for (int i = 0; i < f.n; ++i)
    for (int d = 0; d < D; ++d) component(f.v[i], d) = Real(any(generator));
  if constexpr (requires { f.rho_memory; })
    for (int i = 0; i < f.n; ++i) f.rho[i] = solver.c.rho0 * Real(1 + 0.02 * any(generator));
  double scale = 0;
  for (int i = 0; i < f.n; ++i) scale += m * double(norm(f.v[i]));
  const auto before = momentum<D>(f, m);
  for (int k = 0; k < 100; ++k) {
    patch.run(dt, 1);
    for (int i = 0; i < f.n; ++i) scale += dt * m * double(norm(f.a[i]));
  }
  return norm(momentum<D>(f, m) - before) / scale;
}

template <class T> class Momentum : public ::testing::Test {};
template <int d> struct Dimension { static constexpr int D = d; };
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Momentum, Dimensions);

TYPED_TEST(Momentum, IsConservedByMueller2003) {
  constexpr int D = TypeParam::D;
  using Solver = Mueller2003<D, ReferenceBackend<D>>;
  for (const auto integrator :
       {Integrator::symplectic_euler, Integrator::leapfrog, Integrator::verlet})
    EXPECT_LT((drift<D>(Solver{mueller2003_patch<D>(integrator)})), 1e-6);
}

TYPED_TEST(Momentum, IsConservedByWcsph) {
  constexpr int D = TypeParam::D;
  using Solver = Wcsph<D, ReferenceBackend<D>, CubicSpline>;
  const auto c = weakly_compressible_patch<D>(Integrator::symplectic_euler);
  EXPECT_LT((drift<D>(Solver{c, CubicSpline<D>(c.support)})), 1e-6);
}

TYPED_TEST(Momentum, IsConservedByDeltaSph) {
  constexpr int D = TypeParam::D;
  using Solver = DeltaSph<D, ReferenceBackend<D>, WendlandC2>;
  auto c = weakly_compressible_patch<D>(Integrator::leapfrog);
  for (const bool antuono : {false, true}) {
    c.antuono = antuono;
    EXPECT_LT((drift<D>(Solver{c, WendlandC2<D>(c.support)})), 1e-6);
  }
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/free_patch.h"

namespace freshet {
namespace {

using Forces = Mueller2003Forces<2>;
using Densities = ForceDensities<2, Real>;

Vec<2, double> momentum(const FreePatch& patch, Real m) {
  Vec<2, double> sum{};
  for (int i = 0; i < patch.fluid.n; ++i)
    sum += Vec<2, double>{double(m) * double(patch.fluid.v[i].x),
                          double(m) * double(patch.fluid.v[i].y)};
  return sum;
}

constexpr double dt = 0.001;

/// The article's scheme without a speed limit.
Mueller2003Parameters<2> parameters() {
  auto c = mueller2003_patch<2>(Integrator::leapfrog);
  c.article = true;
  return c;
}

/// A step of the article's integrator, composed of the public parts. `divide` divides the force
/// densities by rho_i; without it they are used as accelerations.
void step_by_hand(FreePatch& patch, const Mueller2003Parameters<2>& c, bool divide) {
  patch.backend.find_neighbors("neighbors", c.h, patch.fluid);
  const auto f = patch.fluid;
  patch.backend.sum_pairs("density", f, over(f, Density{Poly6<2>(c.h), c.m_density}),
                          [&](int i, Real sum) {
                            f.rho[i] = sum;
                            f.p[i] = c.k * (sum - c.rho0);
                          });
  const Forces forces{
      Spiky<2>(c.h, c.spiky_factor), ViscosityKernel<2>(c.h), c.m, c.mu, f.p, f.rho, f.v};
  patch.backend.sum_pairs("forces", f, over(f, forces), [&](int i, const Densities& sum) {
    f.a[i] = (sum.pressure + sum.viscosity) / (divide ? f.rho[i] : Real(1));
  });
  patch.backend.for_each("kick, drift", f, [&](int i) {
    f.v[i] += Real(dt) * f.a[i];
    f.x[i] += Real(dt) * f.v[i];
  });
}

/// |change of the total momentum| divided by the sum of |m v| at the end.
double drift(FreePatch& patch, const Mueller2003Parameters<2>& c, bool divide) {
  const auto before = momentum(patch, c.m);
  for (int k = 0; k < 200; ++k) step_by_hand(patch, c, divide);
  double scale = 0;
  for (int i = 0; i < patch.fluid.n; ++i) scale += double(c.m * norm(patch.fluid.v[i]));
  return norm(momentum(patch, c.m) - before) / scale;
}

// The pair has two different densities.
TEST(ArticleForces, AreEqualAndOppositeOnlyAfterDivisionByDensity) {
  const Forces forces{Spiky<2>(1), ViscosityKernel<2>(1), 2, Real(0.1), {}, {}, {}};
  const Forces::At<Real> a{7, Real(0.8), {1, 0}}, b{5, Real(1.3), {0, 2}};
  const Vec<2> x_ab{Real(0.3), Real(0.4)};
  const Densities on_a = forces(Pair<2, Real>(x_ab), a, b);
  const Densities on_b = forces(Pair<2, Real>(Real(-1) * x_ab), b, a);
  for (const auto part : {&Densities::pressure, &Densities::viscosity}) {
    const Vec<2> f_a = on_a.*part, f_b = on_b.*part;
    const Real scale = norm(f_a);
    EXPECT_LT(norm(f_a / a.rho + f_b / b.rho), Real(1e-6) * scale);
    EXPECT_GT(norm(f_a + f_b), Real(0.3) * scale);  // used as accelerations
  }
}

// Measured drift: 1e-8 of the sum of |m v| with the division, 0.5 % without.
TEST(ArticleForces, ConserveMomentumOnlyWithDivisionByDensity) {
  const auto c = parameters();
  FreePatch with({c}), without({c});
  const double kept = drift(with, c, true), lost = drift(without, c, false);
  EXPECT_LT(kept, 1e-6);
  EXPECT_GT(lost, 1e-3);

  // The steps by hand with division have the solver's bits.
  FreePatch solver({c});
  solver.run(dt, 200);
  for (int i = 0; i < solver.fluid.n; ++i) {
    ASSERT_EQ(solver.fluid.v[i].x, with.fluid.v[i].x);
    ASSERT_EQ(solver.fluid.v[i].y, with.fluid.v[i].y);
  }
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/article_scene.h"
#include "freshet/derived.h"
#include "kernels/lattice_sum.h"
#include "kernels/poly6.h"
#include "kernels/spiky.h"

namespace freshet {
namespace {

Pair<2, Real> along_x(double r) { return Pair<2, Real>(Vec<2>{Real(r), 0}); }

/// The integral of W over the disc, as a sum over a lattice of 250 spacings per h.
template <class Kernel> double integral(const Kernel& W, double h) {
  return lattice_sum<2>(W, h / 250, h);
}

// The article measures a sum of 0.84 at h = 0.2 and calls it the integral.
TEST(ArticleKernels, Poly6IntegratesToOneForEverySupport) {
  for (const double h : {0.01, 0.2, 0.5, 3.0, 20.0})
    EXPECT_NEAR(1, integral(Poly6<2>(Real(h)), h), 1e-5) << h;
}

// The 0.84 that the article measured is the mean density of a lattice with 4 neighbours and edges.
TEST(ArticleKernels, FourNeighborsGiveTheMeasuredDensity) {
  const Scene scene = article_scene();
  const Derived d = derive(scene);
  EXPECT_EQ(4, d.neighbors);
  EXPECT_NEAR(0.889, d.mass / square(d.spacing), 5e-4);  // mass per area
  EXPECT_NEAR(0.956, 1 + d.density_error, 5e-4);         // share that the sum gives
  const double inside = d.mass / square(d.spacing) * (1 + d.density_error);
  EXPECT_NEAR(0.850, inside, 5e-4);

  const Simulation start = after_steps(scene, 1);  // a step computes the densities of its start
  EXPECT_NEAR(0.842, start.statistics().density_mean, 5e-4);
  const auto density = start.fluid().density;
  double whole = 0;  // mean over the particles that are not on the block's edge
  for (int row = 1; row < 24; ++row)
    for (int column = 1; column < 23; ++column) whole += double(density[row * 24 + column]);
  EXPECT_NEAR(inside, whole / (22 * 23), 2e-3);  // the jitter makes the difference

  const Simulation even = after_steps(article_scene({{"particles.jitter", "0"}}), 1);
  EXPECT_NEAR(0.841, even.statistics().density_mean, 5e-4);
}

// The mass of a particle decides between 0.84 and 1000. A kernel does not depend on the units.
TEST(ArticleKernels, MassDecidesTheDensityNotTheUnits) {
  const Scene scene = article_scene({{"particles.mass", "22.5"}, {"fluid.rest_density", "1000"}});
  EXPECT_NEAR(1000 * (1 + derive(scene).density_error), 956, 0.5);
  EXPECT_NEAR(947, after_steps(scene, 1).statistics().density_mean, 0.5);
}

/// Spiky in 2D with the constant that makes its integral 1: 10/(pi h^5).
struct NormalizedSpiky {
  double h;
  double operator()(double r) const { return 10 / (M_PI * std::pow(h, 5)) * std::pow(h - r, 3); }
  double operator()(const Pair<2, Real>& ij) const {
    return ij.r < h ? (*this)(double(ij.r)) : 0.0;
  }
};

// The article's factor 10 is the constant of W itself. The derivative has a further factor of 3.
TEST(ArticleKernels, SpikysGradientHasFactorThirty) {
  const double h = 0.2, d = 1e-6;
  const NormalizedSpiky W{h};
  EXPECT_NEAR(1, integral(W, h), 1e-5);
  for (const double r : {0.01, 0.05, 0.1, 0.15, 0.19}) {
    const double slope = (W(r + d) - W(r - d)) / (2 * d);
    EXPECT_NEAR(1, double(Spiky<2>(Real(h)).gradient(along_x(r)).x) / slope, 1e-4) << r;
    EXPECT_NEAR(1, double(Spiky<2>(Real(h), 10).gradient(along_x(r)).x) / (slope / 3), 1e-4) << r;
  }
}

}  // namespace
}  // namespace freshet

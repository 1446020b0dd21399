// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "kernels/lattice_sum.h"
#include "kernels/poly6.h"
#include "kernels/spiky.h"
#include "kernels/viscosity.h"

namespace freshet {
namespace {

template <int D>
Pair<D, Real> along_x(double r) {
  Vec<D> x{};
  x.x = Real(r);
  return Pair<D, Real>(x);
}

/// Integral over the ball of radius h of f(r), by the midpoint rule in r.
template <int D, class F>
double integral(double h, const F& f) {
  constexpr int steps = 20000;
  const double dr = h / steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double r = (k + 0.5) * dr;
    sum += f(r) * (D == 2 ? 2 * M_PI * r : 4 * M_PI * r * r) * dr;
  }
  return sum;
}

template <class T>
class Kernels : public ::testing::Test {};
template <int d>
struct Dimension {
  static constexpr int D = d;
};
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Kernels, Dimensions);

TYPED_TEST(Kernels, IntegrateToOneForEverySupport) {
  constexpr int D = TypeParam::D;
  for (const double h : {0.01, 0.2, 3.0}) {
    const Poly6<D> poly6{Real(h)};
    const Spiky<D> spiky{Real(h)};
    EXPECT_NEAR(1, integral<D>(h, [&](double r) { return poly6(along_x<D>(r)); }), 1e-5);
    EXPECT_NEAR(1, integral<D>(h, [&](double r) { return spiky(along_x<D>(r)); }), 1e-5);
  }
}

TYPED_TEST(Kernels, SpikysGradientIsItsSlope) {
  constexpr int D = TypeParam::D;
  const double h = 0.2;
  const Spiky<D> W{Real(h)};
  const double scale = std::abs(W.gradient(along_x<D>(h / 2)).x);
  for (const double r : {0.02, 0.05, 0.1, 0.15, 0.19}) {
    const double d = 1e-3, slope = (W(along_x<D>(r + d)) - W(along_x<D>(r - d))) / (2 * d);
    EXPECT_NEAR(slope, W.gradient(along_x<D>(r)).x, 1e-3 * scale) << r;
  }
  EXPECT_EQ(0, W.gradient(along_x<D>(0)).x);
  EXPECT_EQ(0, W.gradient(along_x<D>(h)).x);
}

// By Green's formula the integral of r^2 lap W is 2 D times that of W, which must be 1.
TYPED_TEST(Kernels, TheViscosityLaplacianIsThatOfAKernel) {
  constexpr int D = TypeParam::D;
  for (const double h : {0.01, 0.2, 3.0}) {
    const ViscosityKernel<D> W{Real(h)};
    const auto f = [&](double r) { return r * r * W.laplacian(along_x<D>(r)); };
    EXPECT_NEAR(2 * D, integral<D>(h, f), 1e-4);
    EXPECT_GE(W.laplacian(along_x<D>(h * 0.999)), 0);
    EXPECT_EQ(0, W.laplacian(along_x<D>(h * 1.001)));
  }
}

TYPED_TEST(Kernels, LatticeSumsTendToOne) {
  constexpr int D = TypeParam::D;
  for (const double ratio : {4.0, 8.0, 16.0}) {
    const double sum = lattice_sum<D>(Poly6<D>(Real(ratio)), 1.0, ratio);
    EXPECT_NEAR(1, sum, 0.5 / (ratio * ratio)) << ratio;  // the error is at most of second order
  }
}

}  // namespace
}  // namespace freshet

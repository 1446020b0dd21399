// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/cubic_spline.h"
#include "kernels/lattice_sum.h"
#include "kernels/poly6.h"
#include "kernels/spiky.h"
#include "kernels/viscosity.h"
#include "kernels/wendland.h"
#include "pairs/density.h"

namespace freshet {
namespace {

template <template <int> class K, int d> struct In {
  static constexpr int D = d;
  using Kernel = K<d>;
  template <int n> using KernelIn = K<n>;
};
template <template <int> class... K> using InBoth = ::testing::Types<In<K, 2>..., In<K, 3>...>;

template <class T> class DensityKernels : public ::testing::Test {};
using AllDensityKernels = InBoth<Poly6, CubicSpline, WendlandC2, WendlandC4, WendlandC6>;
TYPED_TEST_SUITE(DensityKernels, AllDensityKernels);

template <class T> class GradientKernels : public ::testing::Test {};
using AllGradientKernels = InBoth<Spiky, CubicSpline, WendlandC2, WendlandC4, WendlandC6>;
TYPED_TEST_SUITE(GradientKernels, AllGradientKernels);

template <class T> class LaplacianKernels : public ::testing::Test {};
TYPED_TEST_SUITE(LaplacianKernels, InBoth<ViscosityKernel>);

template <int D, class R = Real> Pair<D, R> along_x(double r) {
  Vec<D, R> x{};
  x.x = R(r);
  return Pair<D, R>(x);
}
/// A point at distance r in an oblique direction.
template <int D> Vec<D, double> aside(double r) {
  if constexpr (D == 3) return {r * 2 / 7, r * -3 / 7, r * 6 / 7};
  else return {r * 3 / 5, r * -4 / 5};
}

/// Integral over the ball of radius h of f(r), by the midpoint rule in r.
template <int D, class F> double integral(double h, const F& f) {
  constexpr int steps = 20000;
  const double dr = h / steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double r = (k + 0.5) * dr;
    sum += f(r) * (D == 2 ? 2 * M_PI * r : 4 * M_PI * r * r) * dr;
  }
  return sum;
}

template <int D, class Kernel> void expect_integral_one() {
  for (const double h : {0.01, 0.2, 3.0}) {
    const Kernel W{Real(h)};
    EXPECT_NEAR(1, integral<D>(h, [&](double r) { return W(along_x<D>(r)); }), 1e-5) << h;
  }
}
TYPED_TEST(DensityKernels, IntegrateToOneForEverySupport) {
  expect_integral_one<TypeParam::D, typename TypeParam::Kernel>();
}
TYPED_TEST(GradientKernels, IntegrateToOneForEverySupport) {
  expect_integral_one<TypeParam::D, typename TypeParam::Kernel>();
}

TYPED_TEST(DensityKernels, VanishFromTheSupportOn) {
  constexpr int D = TypeParam::D;
  for (const double h : {0.013, 0.2, 3.0}) {
    const typename TypeParam::Kernel W{Real(h)};
    EXPECT_GT(W(along_x<D>(0.9 * h)), 0);
    EXPECT_EQ(0, W(along_x<D>(h)));
    EXPECT_EQ(0, W(along_x<D>(1.001 * h)));
    EXPECT_EQ(0, W(along_x<D>(1e9)));  // distance of the far particle that pads neighbour lists
  }
}

TYPED_TEST(GradientKernels, EqualTheSlopeOfTheKernel) {
  constexpr int D = TypeParam::D;
  const double h = 0.2, step = 2e-5 * h;
  const typename TypeParam::Kernel W{Real(h)};
  const double scale = std::abs(W.gradient(along_x<D>(h / 2)).x);
  for (double r = 0.02 * h; r < 1.1 * h; r += 0.0173 * h) {
    auto gradient = W.gradient(Pair<D, double>(aside<D>(r)));
    for (int k = 0; k < D; ++k) {
      Vec<D, double> ahead = aside<D>(r), behind = ahead;
      component(ahead, k) += step;
      component(behind, k) -= step;
      const double slope = (W(Pair<D, double>(ahead)) - W(Pair<D, double>(behind))) / (2 * step);
      EXPECT_NEAR(slope, component(gradient, k), 1e-5 * scale) << r / h;
    }
  }
}

TYPED_TEST(GradientKernels, VanishAtTheCentreAndFromTheSupportOn) {
  constexpr int D = TypeParam::D;
  for (const double h : {0.013, 0.2, 3.0}) {
    const typename TypeParam::Kernel W{Real(h)};
    for (const double r : {0.0, h, 1.001 * h, -1.001 * h, 1e9, -1e9}) {
      auto gradient = W.gradient(along_x<D>(r));
      for (int k = 0; k < D; ++k) EXPECT_EQ(0, component(gradient, k)) << r;
    }
    EXPECT_LT(W.gradient(along_x<D>(0.9 * h)).x, 0);
  }
}

TYPED_TEST(GradientKernels, AreAntisymmetric) {
  constexpr int D = TypeParam::D;
  const typename TypeParam::Kernel W{Real(0.2f)};
  for (double r = 1e-5; r < 0.22; r += 0.0037) {
    const auto x = aside<D>(r);
    auto there = W.gradient(Pair<D, double>(x)), back = W.gradient(Pair<D, double>(-1.0 * x));
    for (int k = 0; k < D; ++k) EXPECT_EQ(component(there, k), -component(back, k)) << r;
  }
}

// By Green's formula, the integral of r² lap W is 2 D times the integral of W, which must be 1.
TYPED_TEST(LaplacianKernels, BelongToAKernelOfIntegralOne) {
  constexpr int D = TypeParam::D;
  for (const double h : {0.01, 0.2, 3.0}) {
    const typename TypeParam::Kernel W{Real(h)};
    const auto f = [&](double r) { return r * r * W.laplacian(along_x<D>(r)); };
    EXPECT_NEAR(2 * D, integral<D>(h, f), 1e-4);
    EXPECT_GE(W.laplacian(along_x<D>(h * 0.999)), 0);
    EXPECT_EQ(0, W.laplacian(along_x<D>(h * 1.001)));
  }
}

TYPED_TEST(DensityKernels, LatticeSumsTendToOne) {
  constexpr int D = TypeParam::D;
  for (const double ratio : {4.0, 8.0, 16.0}) {
    const double sum = lattice_sum<D>(typename TypeParam::Kernel(Real(ratio)), 1.0, ratio);
    EXPECT_NEAR(1, sum, 0.5 / (ratio * ratio)) << ratio;  // the error is of second order or higher
  }
}

// Sums over the particles of a block as a solver does, not over the offsets of lattice_sum.
TYPED_TEST(DensityKernels, GiveARestingLatticeItsRestDensity) {
  constexpr int D = TypeParam::D;
  const double rho0 = 1000, spacing = 0.05;
  for (double ratio = 2; ratio <= 4; ratio += 0.25) {
    const typename TypeParam::Kernel W{Real(ratio * spacing)};
    const int deep = int(std::ceil(ratio)), side = 2 * deep + 3;
    std::vector<Vec<D>> block;
    std::vector<bool> inside;
    for (int k = 0; k < (D == 3 ? side * side * side : side * side); ++k) {
      Vec<D> x;
      bool in = true;
      for (int d = 0, part = k; d < D; ++d, part /= side) {
        component(x, d) = Real(0.7 + spacing * (part % side));
        in = in && part % side >= deep && part % side < side - deep;
      }
      block.push_back(x);
      inside.push_back(in);
    }
    const Real m = Real(rho0 * std::pow(spacing, D) / lattice_sum<D>(W, spacing, ratio * spacing));
    const Density<D, TypeParam::template KernelIn> term{W, m};
    double mean = 0;
    int count = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (!inside[i]) continue;
      Real rho = 0;
      for (const Vec<D>& x_j : block) rho += term(Pair<D, Real>(block[i] - x_j), {}, {});
      mean += double(rho);
      ++count;
    }
    EXPECT_EQ(D == 2 ? 9 : 27, count);
    EXPECT_NEAR(1, mean / count / rho0, 1e-3) << ratio;
  }
}

// A float's squares of gradients overflow at 1e-5 m and are 0 at 1e6 m in 3D.
TEST(LatticeResponse, ScalesWithTheSpacing) {
  const double stiffness = lattice_stiffness<3>(CubicSpline<3>(2), 1, 2);
  for (const double spacing : {1e-6, 1e-5, 1e-3, 1.0, 1e3, 1e5, 1e6}) {
    const auto support = Real(2 * spacing);
    const double in_2d = lattice_response<2>(CubicSpline<2>(support), spacing, 2 * spacing),
                 in_3d = lattice_response<3>(CubicSpline<3>(support), spacing, 2 * spacing);
    EXPECT_NEAR(0.52003, in_2d * std::pow(spacing, 6), 1e-5) << spacing;
    EXPECT_NEAR(0.42484, in_3d * std::pow(spacing, 8), 1e-5) << spacing;
    EXPECT_NEAR(stiffness, lattice_stiffness<3>(CubicSpline<3>(support), spacing, 2 * spacing),
                1e-4)
        << spacing;
  }
}

/// The sum of -x . grad W / D over the lattice: the discrete gradient of a linear field of slope 1.
template <int D, class Kernel> double gradient_sum(const Kernel& W, double ratio) {
  const auto slope = [&](const Pair<D, Real>& ij) { return -dot(ij.x, W.gradient(ij)) / D; };
  return lattice_sum<D>(slope, 1.0, ratio);
}

template <template <int> class Kernel> void expect_sums(double ratio, double in_2d, double in_3d) {
  EXPECT_NEAR(in_2d, lattice_sum<2>(Kernel<2>(Real(ratio)), 1.0, ratio), 1e-3);
  EXPECT_NEAR(in_3d, lattice_sum<3>(Kernel<3>(Real(ratio)), 1.0, ratio), 1e-3);
}
template <template <int> class Kernel>
void expect_gradient_sums(double ratio, double in_2d, double in_3d) {
  EXPECT_NEAR(in_2d, gradient_sum<2>(Kernel<2>(Real(ratio)), ratio), 1e-3);
  EXPECT_NEAR(in_3d, gradient_sum<3>(Kernel<3>(Real(ratio)), ratio), 1e-3);
}

// docs/solvers.md recommends supports from these values: two spacings for the cubic spline, three
// for smoother kernels.
TEST(LatticeErrors, HaveTheRecordedValues) {
  expect_sums<Poly6>(2, 1.015, 1.010);
  expect_sums<CubicSpline>(2, 1.001, 1.000);
  expect_sums<WendlandC2>(2, 1.038, 1.034);
  expect_sums<WendlandC4>(2, 1.046, 1.067);
  expect_sums<WendlandC6>(2, 1.104, 1.169);
  expect_sums<Poly6>(3, 1.002, 1.002);
  expect_sums<CubicSpline>(3, 1.003, 1.002);
  expect_sums<WendlandC2>(3, 1.005, 1.003);
  expect_sums<WendlandC4>(3, 1.003, 1.003);
  expect_sums<WendlandC6>(3, 1.003, 1.003);
  expect_gradient_sums<CubicSpline>(2, 1.013, 1.020);
  expect_gradient_sums<WendlandC2>(2, 0.976, 0.982);
  expect_gradient_sums<WendlandC4>(2, 0.862, 0.858);
  expect_gradient_sums<WendlandC6>(2, 0.698, 0.717);
  expect_gradient_sums<CubicSpline>(3, 1.007, 1.010);
  expect_gradient_sums<WendlandC2>(3, 0.997, 1.001);
  expect_gradient_sums<WendlandC4>(3, 0.991, 0.993);
  expect_gradient_sums<WendlandC6>(3, 0.991, 0.994);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "boundary/open_sides.h"

#include <gtest/gtest.h>

namespace freshet::test {
namespace {

constexpr unsigned x_min = 1, x_max = 2, y_min = 4, y_max = 8;
constexpr Vec<2, double> down{0, -9.81};

/// A domain of 2 m × 1 m with a support radius of 0.1 m.
OpenSides<2> domain(unsigned open) {
  return {{0, 0}, {2, 1}, 0.1, open, (x_min | x_max | y_min | y_max) & ~open};
}

/// The side through which x has left. Expects may_have_left() to agree with it.
int left(const OpenSides<2>& sides, Vec<2, double> x, Vec<2, double> a = down) {
  const int side = sides.left_through(x, a);
  EXPECT_TRUE(side < 0 || sides.may_have_left(x)) << x.x << " " << x.y;
  return side;
}

TEST(OpenSides, AParticleLeavesBeyondTwoSupportRadii) {
  const auto sides = domain(x_max | y_min);
  EXPECT_EQ(-1, left(sides, {1, 0.5}));
  EXPECT_EQ(-1, left(sides, {2.19, 0.5}));
  EXPECT_EQ(1, left(sides, {2.21, 0.5}));
  EXPECT_EQ(-1, left(sides, {1, -0.19}));
  EXPECT_EQ(2, left(sides, {1, -0.21}));
  EXPECT_EQ(1, left(sides, {3, -3})) << "the first of two sides counts";
  EXPECT_EQ(-1, left(sides, {-5, 0.5})) << "a closed side is not open";
  EXPECT_FALSE(sides.may_have_left({2.19, 0.5}));
  EXPECT_EQ(-1, left(sides, {NAN, NAN})) << "the health check reports it";
}

TEST(OpenSides, AParticleThatIsPulledBackStays) {
  const auto sides = domain(x_max | y_max);
  EXPECT_EQ(-1, left(sides, {1, 50}));
  EXPECT_EQ(3, left(sides, {1, 50}, {0, 1}));
  EXPECT_EQ(3, left(sides, {1, 50}, {0, 0})) << "without gravity it flies on";
  EXPECT_EQ(1, left(sides, {3, 50})) << "it may leave through another side";
  EXPECT_EQ(-1, left(sides, {3, 50}, {-1, -1}));
  EXPECT_EQ(-1, left(sides, {3, 0.5}, {-1, 0}));
}

TEST(OpenSides, AParticleBesideAWallHasLeftOverItsEdge) {
  const auto sides = domain(y_max);
  EXPECT_EQ(-1, left(sides, {2.04, 1.5})) << "on the rim of the wall";
  EXPECT_EQ(3, left(sides, {2.06, 1.5}));
  EXPECT_EQ(3, left(sides, {-0.06, 1.001}));
  EXPECT_EQ(-1, left(sides, {2.06, 0.9})) << "it went through the wall, which is a fault";
}

TEST(OpenSides, APeriodicAxisHasNoSides) {
  const OpenSides<2> sides{{0, 0}, {2, 1}, 0.1, y_max, y_min};
  EXPECT_EQ(-1, left(sides, {5, 1.5}));
}

}  // namespace
}  // namespace freshet::test

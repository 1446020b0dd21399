// SPDX-License-Identifier: MIT
// The motion of single whitewater particles.
#include "solvers/ihmsen2012.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace freshet {
namespace {

/// One particle with so many fluid particles around it, of 30 inside.
struct One {
  explicit One(Real around) : near(around) {
    c.neighbors_inside = 30;
    c.buoyancy = 2;
    c.rise_speed = Real(0.25f);
    set.n = 1;
    set.x.data = &x;
    set.v.data = &v;
    set.kind.data = &kind;
    set.age.data = &age;
    set.life.data = &life;
    set.around.data = &flow;
    set.near.data = &near;
  }
  void move(Real dt) { MoveWhitewater<2>{c, set, {}, {0, Real(-10)}, dt}(0); }

  Ihmsen2012Parameters<2> c{};
  WhitewaterParticles<2> set;
  Vec<2> x{}, v{}, flow{};
  int kind = -1;
  Real age = 0, life = 1, near;
};

TEST(Ihmsen2012, SprayFliesFreely) {
  One spray(5);
  spray.v = {2, 0};
  for (int k = 0; k < 10; ++k) spray.move(Real(0.01f));
  EXPECT_EQ(int(WhitewaterKind::spray), spray.kind);
  EXPECT_NEAR(0.2, double(spray.x.x), 1e-6);
  EXPECT_NEAR(-1, double(spray.v.y), 1e-6);
  EXPECT_EQ(Real(1), spray.life) << "only foam dissolves";
}

TEST(Ihmsen2012, FoamMovesWithTheFluidAndDissolves) {
  One foam(12);
  foam.flow = {1, 2};
  for (int k = 0; k < 10; ++k) foam.move(Real(0.01f));
  EXPECT_EQ(int(WhitewaterKind::foam), foam.kind);
  EXPECT_NEAR(0.1, double(foam.x.x), 1e-6);
  EXPECT_NEAR(0.2, double(foam.x.y), 1e-6);
  EXPECT_NEAR(0.9, double(foam.life), 1e-6);
  EXPECT_NEAR(0.1, double(foam.age), 1e-6);
}

// It starts with k_b g = 20 m/s^2 and approaches 0.25 m/s above the flow, for any time step.
TEST(Ihmsen2012, BubblesRiseAtTheirSpeed) {
  One first(30);
  first.move(Real(1e-4f));
  EXPECT_EQ(int(WhitewaterKind::bubble), first.kind);
  EXPECT_NEAR(20e-4, double(first.v.y), 2e-5);
  for (const double dt : {0.001, 0.1}) {
    One bubble(30);
    bubble.flow = {Real(0.5f), 0};
    for (int k = 0; k < 200; ++k) bubble.move(Real(dt));
    EXPECT_NEAR(0.5, double(bubble.v.x), 1e-4);
    EXPECT_NEAR(0.25, double(bubble.v.y), 1e-4);
  }
}

TEST(Ihmsen2012, WallsPushOutAndStopTheInwardVelocity) {
  One drop(5);
  drop.v = {1, -3};
  const KeepOutOfWalls<2> keep{drop.set, Real(0.1f)};
  keep(0, {Real(0.4f), {0, Real(0.02f)}, {}});
  EXPECT_EQ(Real(-3), drop.v.y) << "it is in front of the wall";
  keep(0, {Real(0.8f), {0, Real(0.02f)}, {}});
  EXPECT_NEAR(0.03, double(drop.x.y), 1e-6);
  EXPECT_EQ(Real(1), drop.v.x);
  EXPECT_NEAR(0, double(drop.v.y), 1e-6);
  keep(0, {Real(0.8f), {0, Real(0.02f)}, {0, Real(1.6f)}});  // the wall moves at 2 m/s
  EXPECT_NEAR(2, double(drop.v.y), 1e-6);
}

TEST(Ihmsen2012, PotentialsGrowBetweenTheirLimits) {
  const Limits limits{1, 3};
  EXPECT_EQ(Real(0), limits(Real(0.5f)));
  EXPECT_EQ(Real(0.5f), limits(2));
  EXPECT_EQ(Real(1), limits(10));
}

// Two particles that approach each other: |v_ij| (1 - v_ij x_ij/..) is twice the speed; if they
// part it is 0.
TEST(Ihmsen2012, ApproachTrapsAir) {
  Vec<2> v[] = {{1, 0}, {-1, 0}};
  const Ihmsen2012TrappedAir<2> term{1, {v}};
  const auto sums = [&](Real x) {
    return term(Pair<2, Real>({x, 0}), term.at(0), term.neighbor(1));
  };
  EXPECT_NEAR(4, double(sums(Real(-0.5f)).mean()), 1e-6);
  EXPECT_NEAR(0, double(sums(Real(0.5f)).mean()), 1e-6);
  EXPECT_EQ(Real(0), sums(2).weight) << "beyond the support";
  EXPECT_EQ(Real(0), sums(0).neighbors) << "the particle itself";
}

TEST(Ihmsen2012, NormalsThatTurnMakeACrest) {
  Vec<2> n[] = {{0, 1}, {1, 0}, {0, 0}};
  const Ihmsen2012WaveCrest<2> term{1, {n}};
  const auto mean = [&](Real y, int j) {
    return double(term(Pair<2, Real>({0, y}), term.at(0), term.neighbor(j)).mean());
  };
  EXPECT_NEAR(1, mean(Real(0.5f), 1), 1e-6);
  EXPECT_NEAR(0, mean(Real(0.5f), 0), 1e-6) << "the same normal";
  EXPECT_NEAR(0, mean(Real(0.5f), 2), 1e-6) << "inside";
  EXPECT_NEAR(0, mean(Real(-0.5f), 1), 1e-6) << "above the tangent plane";
}

TEST(Draws, AreUniformAndOfTheirKeysAlone) {
  Draws a(1, 2, 3), b(1, 2, 3), c(1, 3, 2);
  double sum = 0;
  bool same = true, other = false;
  for (int k = 0; k < 10000; ++k) {
    const double value = a.next();
    ASSERT_TRUE(value >= 0 && value < 1);
    sum += value;
    same &= value == b.next();
    other |= value != c.next();
  }
  EXPECT_NEAR(0.5, sum / 10000, 0.01);
  EXPECT_TRUE(same);
  EXPECT_TRUE(other);
}

}  // namespace
}  // namespace freshet

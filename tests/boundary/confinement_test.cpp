// SPDX-License-Identifier: MIT
#include "boundary/confinement.h"

#include <gtest/gtest.h>

namespace freshet {
namespace {

/// Moves one particle.
template <int D> void apply(const Confinement<D>& c, Vec<D>& x, Vec<D>& v) {
  FluidParticles<D> f{};
  f.x.data = &x;
  c(0, f, v);
}

TEST(Confinement, RecordsTheVelocityChangeByEachWall) {
  Confinement<2> c{};
  c.box = {{0, 0}, {1, 1}, 0.5f, 0b1111, false};
  Vec<2, double> bounced[2]{};
  c.bounced.data = bounced;
  Vec<2> x{-0.1f, 1.2f}, v{-2, 4};
  apply(c, x, v);
  EXPECT_FLOAT_EQ(0.05f, x.x);
  EXPECT_FLOAT_EQ(0.9f, x.y);
  EXPECT_EQ(3, bounced[0].x);  // the low side along x turned -2 into 1
  EXPECT_EQ(0, bounced[0].y);
  EXPECT_EQ(-6, bounced[1].y);  // the high side along y turned 4 into -2
}

TEST(Confinement, OpenSidesLetParticlesPass) {
  Confinement<2> c{};
  c.box = {{0, 0}, {1, 1}, 0.5f, 0b0001, false};
  Vec<2> x{0.5f, -3}, v{0, -1};
  apply(c, x, v);
  EXPECT_EQ(-3, x.y);
  EXPECT_EQ(-1, v.y);
}

TEST(Confinement, PeriodicAxesWrapPositions) {
  Confinement<3> c{};
  c.box = {{0, 0, 0}, {2, 2, 2}, 0.5f, 0, false};
  c.period = {2, 0, 0};
  Vec<3> x{2.25f, 3, -1}, v{1, 1, 1};
  apply(c, x, v);
  EXPECT_EQ(0.25f, x.x);
  EXPECT_EQ(3, x.y);
  EXPECT_EQ(1, v.x);
}

TEST(Confinement, ShapesReflectAlongTheirNormal) {
  Reflector<2> ball{{SolidKind::ball, {0, 0}, {}, {}, 1, 0, false}, 0.5f};
  Confinement<2> c{};
  c.shapes.data = &ball;
  c.shape_count = 1;
  Vec<2, double> bounced[3]{};
  c.bounced.data = bounced;
  Vec<2> x{0.8f, 0}, v{-1, 3};
  apply(c, x, v);
  EXPECT_FLOAT_EQ(1.1f, x.x);  // the overshoot of 0.2, halved, outside
  EXPECT_FLOAT_EQ(0.5f, v.x);
  EXPECT_FLOAT_EQ(3, v.y);
  EXPECT_FLOAT_EQ(1.5f, float(bounced[2].x));
}

TEST(Confinement, NotesBouncesOverTheLightness) {
  Confinement<2> c{};
  c.box = {{0, 0}, {1, 1}, 1, 0b1111, false};
  c.liquids.liquid[1].lightness = 4;
  Vec<2, double> bounced[2]{};
  c.bounced.data = bounced;
  int kind = 1;
  Vec<2> x{-0.1f, 0.5f}, v{-2, 0};
  FluidParticles<2> f{};
  f.x.data = &x;
  f.kind.data = &kind;
  c(0, f, v);
  EXPECT_EQ(1, bounced[0].x) << "4 m/s over 4";
}

}  // namespace
}  // namespace freshet

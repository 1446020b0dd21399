// SPDX-License-Identifier: MIT
#include "boundary/confinement.h"

#include <gtest/gtest.h>

#include <vector>

namespace freshet {
namespace {

/// Moves one particle.
template <int D> void apply(const Confinement<D>& c, Vec<D>& x, Vec<D>& v) {
  FluidParticles<D> f{};
  f.x.data = &x;
  c(0, f, v, x);
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
  c(0, f, v, x);
  EXPECT_EQ(1, bounced[0].x) << "4 m/s over 4";
}

/// A wall from x = 1 to 1.2 that ends at the floor of the domain.
Reflector<2> wall_to_the_floor() {
  return {{SolidKind::box, {1.1f, 0.5f}, {0.1f, 0.5f}, {}, 0, 0, false}, 0.5f};
}

/// Where a particle is after it drifted to x by `drift`.
Vec<2> confined(Confinement<2> c, std::vector<Reflector<2>> shapes, Vec<2> x, Vec<2> drift,
                Vec<2>* v_out = nullptr) {
  c.shapes.data = shapes.data();
  c.shape_count = int(shapes.size());
  c.slack = 1e-6f;
  Vec<2> v = Real(100) * drift;
  FluidParticles<2> f{};
  f.x.data = &x;
  c(0, f, v, x - drift);
  if (v_out) *v_out = v;
  return x;
}

// The nearest face of the wall is its bottom, behind the floor.
TEST(Confinement, DoesNotPushThroughTheEndOfAWall) {
  Confinement<2> c{};
  c.box = {{0, 0}, {2, 1}, 0.5f, 0b1111, false};
  Vec<2> v{};
  const Vec<2> x = confined(c, {wall_to_the_floor()}, {1.02f, 0.005f}, {0.03f, -0.005f}, &v);
  EXPECT_NEAR(1, x.x, 1e-4);
  EXPECT_GE(x.y, 0);
  EXPECT_LT(v.x, 0) << "reflected by the face that it met";
}

// The nearest face of either box is the seam.
TEST(Confinement, HoldsAtTheSeamOfTwoWalls) {
  const Reflector<2> left{{SolidKind::box, {0.5f, 0.4f}, {0.5f, 0.1f}, {}, 0, 0, false}, 0.5f},
      right{{SolidKind::box, {1.5f, 0.4f}, {0.5f, 0.1f}, {}, 0, 0, false}, 0.5f};
  Confinement<2> c{};
  c.box = {{0, 0}, {2, 1}, 0.5f, 0b1111, false};
  for (const Real x : {0.995f, 1.0f, 1.005f}) {
    Vec<2> v{};
    const Vec<2> at = confined(c, {left, right}, {x, 0.48f}, {0.001f, -0.03f}, &v);
    EXPECT_GE(at.y, 0.5f - 1e-4f) << x;
    EXPECT_GT(v.y, 0) << x;
  }
}

TEST(Confinement, HoldsAWallThatIsThinnerThanTheDrift) {
  const Reflector<2> thin{{SolidKind::box, {1, 0.5f}, {0.01f, 0.5f}, {}, 0, 0, false}, 0.5f};
  const Vec<2> x = confined(Confinement<2>{}, {thin}, {1.02f, 0.5f}, {0.05f, 0});
  EXPECT_LT(x.x, 0.99f + 1e-4f);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// Turned boxes, polygons and tanks as rigid bodies.
#include "bodies/body_world.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

/// The height at which a body comes to rest.
double resting_height(const std::string& shape, bool flat) {
  World w("[body]\n" + shape + "motion = \"free\"\ndensity = 500\nrestitution = 0\n", flat);
  w.run(3);
  EXPECT_LT(std::abs(w[0].velocity[1]), 0.05);
  return w[0].position[1];
}

TEST_F(FreeBodies, OfATurnedBoxFallOntoAFace) {
  EXPECT_NEAR(0.25, resting_height("min = [4, 0.5]\nmax = [5, 1]\nrotation = 30\n", true), 0.01);
  EXPECT_NEAR(
      0.25,
      resting_height("min = [4, 0.7, 4]\nmax = [5, 1.2, 5.5]\nrotation = [20, 0, 30]\n", false),
      0.02);
}

TEST_F(FreeBodies, OfAPolygonFallOntoASide) {
  const std::string points = "shape = \"polygon\"\npoints = [[4, 0.4], [5.5, 0.4], [4, 1.3]]\n";
  EXPECT_NEAR(0.3, resting_height(points + "rotation = 3\ntranslation = [0, -0.1]\n", true), 0.01);
}

TEST_F(FreeBodies, StayInAMovedTank) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  for (const bool flat : {true, false}) {
    World w(flat ? "[[body]]\nmin = [4, 4]\nmax = [6, 6]\nside = \"inside\"\nmotion = \"moved\"\n"
                   "position = [\"1 - cos(2*t)\", \"0\"]\n"
                   "[[body]]\nshape = \"sphere\"\ncenter = [5, 4.6]\nradius = 0.5\n"
                   "motion = \"free\"\nmass = 1\n"
                 : "[[body]]\nmin = [4, 4, 4]\nmax = [6, 6, 6]\nside = \"inside\"\n"
                   "motion = \"moved\"\nposition = [\"1 - cos(2*t)\", \"0\", \"0\"]\n"
                   "[[body]]\nshape = \"sphere\"\ncenter = [5, 4.6, 5]\nradius = 0.5\n"
                   "motion = \"free\"\nmass = 1\n",
            flat);
    for (int k = 0; k < 30; ++k) {
      w.run(0.1);
      EXPECT_NEAR(w[0].position[0], w[1].position[0], 0.52) << flat << " " << k;
      EXPECT_GT(w[1].position[1], 4.48) << flat << " " << k;
    }
  }
}

TEST(BodyShapes, OfAPolygonAreThoseOfABox) {
  const Scene s = scene_of(
      "[[body]]\nmin = [4, 4]\nmax = [5, 6]\n"
      "[[body]]\nshape = \"polygon\"\npoints = [[7, 4], [7, 6], [8, 6], [8, 5], [8, 4]]\n");
  const BodyShape box = body_shape(s.body[0]), polygon = body_shape(s.body[1]);
  EXPECT_NEAR(box.volume, polygon.volume, 1e-12);
  EXPECT_NEAR(box.inertia[2][2], polygon.inertia[2][2], 1e-12);
  EXPECT_NEAR(box.reach, polygon.reach, 1e-12);
  EXPECT_NEAR(7.5, polygon.center.x, 1e-12);
  EXPECT_NEAR(5, polygon.center.y, 1e-12);
}

TEST(BodyShapes, OfATurnedBoxHaveATurnedInertia) {
  const Scene s =
      scene_of("[body]\nmin = [4, 4, 4]\nmax = [5, 6, 7]\nrotation = [0, 0, 30]\n", false);
  const BodyShape b = body_shape(s.body[0]);
  const double along = 6 * (4 + 9) / 12.0, across = 6 * (1 + 9) / 12.0;  // of x, of y
  EXPECT_NEAR(0.75 * along + 0.25 * across, b.inertia[0][0], 1e-12);
  EXPECT_NEAR(std::sqrt(3) / 4 * (along - across), b.inertia[0][1], 1e-12);
  EXPECT_NEAR(6 * (1 + 4) / 12.0, b.inertia[2][2], 1e-12);
}

}  // namespace
}  // namespace freshet::test

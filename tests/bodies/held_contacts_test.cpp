// SPDX-License-Identifier: MIT
// Contacts of free bodies with locked axes or a centre of mass that is not that of their shape:
// their collider is a part of a compound.
#include "bodies/body_world.h"

namespace freshet::test {
namespace {

const std::string weighted = "center_of_mass = [4.6, 3.7, 4.5]\ninertia = [80, 90, 80]\n";
const std::string turned = "inertia = [90, 85, 80, 3, 2, 4]\n";

std::string cube(double low, const std::string& keys) {
  return "[[body]]\nmin = [4, " + std::to_string(low) + ", 4]\nmax = [5, " +
         std::to_string(low + 1) + ", 5]\nmotion = \"free\"\nmass = 500\nrestitution = 0\n" + keys;
}

/// The height of the lower face of the first body after 2 s, which must not have turned.
double face_at_rest(const std::string& walls, const std::string& keys) {
  World w(cube(3, keys) + walls, false);
  const double above = w[0].position[1] - 3;
  w.run(2);
  EXPECT_NEAR(0, w[0].velocity[1], 1e-3) << keys;
  EXPECT_NEAR(1, w[0].orientation[3], 1e-4) << keys;
  return w[0].position[1] - above;
}

const std::string held[] = {"lock = [\"rotation_x\"]\n",
                            "lock = [\"rotation_x\", \"rotation_y\", \"rotation_z\"]\n",
                            "lock = [\"x\", \"z\"]\n", weighted, turned};

TEST_F(FreeBodies, RestOnTheFloorWithLocksOrTheirOwnCentreOfMass) {
  for (const std::string& keys : held) EXPECT_NEAR(0, face_at_rest("", keys), 1e-3) << keys;
}

TEST_F(FreeBodies, RestOnAWallBoxWithLocksOrTheirOwnCentreOfMass) {
  const std::string plate = "[[wall]]\nmin = [3, 0, 3]\nmax = [6, 2, 6]\n";
  for (const std::string& keys : held) EXPECT_NEAR(2, face_at_rest(plate, keys), 2e-3) << keys;
}

TEST_F(FreeBodies, WithLocksRestOnOneAnother) {
  const std::string lock = "lock = [\"rotation_x\", \"rotation_z\"]\n";
  World w(cube(0.2, lock) + cube(1.4, lock), false);
  w.run(2);
  EXPECT_NEAR(0.5, w[0].position[1], 2e-3);
  EXPECT_NEAR(1.5, w[1].position[1], 4e-3);
}

TEST_F(FreeBodies, WithLocksTouchAcrossAPeriodicEnd) {
  World w(
      "[[body]]\nmin = [0.2, 4, 4]\nmax = [1.2, 5, 5]\nmotion = \"free\"\nmass = 1\n"
      "lock = [\"rotation_x\", \"rotation_y\", \"rotation_z\"]\nvelocity = [-1, 0, 0]\n"
      "[[body]]\nmin = [8.5, 4, 4]\nmax = [9.5, 5, 5]\nmotion = \"free\"\nmass = 1\n"
      "lock = [\"rotation_x\", \"rotation_y\", \"rotation_z\"]\n",
      false, "gravity = [0, 0, 0]\nperiodic = \"x\"\n");
  w.run(2);
  EXPECT_NEAR(-1, w[0].velocity[0] + w[1].velocity[0], 1e-3);
  EXPECT_LT(w[1].velocity[0], -0.4) << "they met after 0.7 s";
}

// The slope pushes sideways, which a lock takes up: a matrix of the free body would stop it half.
TEST_F(FreeBodies, WithALockedXRestOnASlope) {
  World w(
      "[body]\nshape = \"sphere\"\ncenter = [5, 5.8]\nradius = 0.5\nmotion = \"free\"\nmass = 1\n"
      "restitution = 0\nfriction = 0\nlock = [\"x\"]\n"
      "[[wall]]\nshape = \"plane\"\npoint = [5, 5]\nnormal = [1, 1]\n");
  w.run(1);
  EXPECT_EQ(5, w[0].position[0]);
  EXPECT_NEAR(5 + 0.5 * std::sqrt(2), w[0].position[1], 2e-3);
  EXPECT_NEAR(0, w[0].velocity[1], 1e-3);
}

// A locked rotation makes a body answer at a corner as at its middle.
TEST_F(FreeBodies, WithALockedRotationBounceAtACorner) {
  World w(
      "[[body]]\nmin = [4, 4]\nmax = [6, 5]\nmotion = \"free\"\nmass = 1\nrestitution = 1\n"
      "friction = 0\nlock = [\"rotation_z\"]\nvelocity = [0, -1]\n"
      "[[wall]]\nmin = [5.7, 2]\nmax = [6.5, 3.7]\n",
      true, "gravity = [0, 0]\n");
  w.run(1);
  EXPECT_NEAR(1, w[0].velocity[1], 0.02);
  EXPECT_EQ(0, w[0].angular_velocity[2]);
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// Free bodies whose mass is set by hand, and bodies with locked axes.
#include <numbers>

#include "bodies/body_world.h"
#include "core/rotation.h"

namespace freshet::test {
namespace {

using Point3 = Vec<3, double>;

/// A pendulum's angle falls below 0 after half a period.
double half_period(World& w) {
  for (double t = 0; t < 4; t += 0.001) {
    w.run(0.001);
    if (t > 0.2 && angle_of(w[0]) < 0) return t;
  }
  return INFINITY;
}

Point3 momentum_of(const BodyState& b, const double (&inertia)[3][3]) {
  const Rotation turn(b.orientation);
  const auto& v = b.angular_velocity;
  const Point3 w = turn.inverse({v[0], v[1], v[2]});
  const auto row = [&](int i) {
    return inertia[i][0] * w.x + inertia[i][1] * w.y + inertia[i][2] * w.z;
  };
  return turn({row(0), row(1), row(2)});
}

double energy_of(const BodyState& b, const double (&inertia)[3][3]) {
  const auto& v = b.angular_velocity;
  return 0.5 * dot(Point3{v[0], v[1], v[2]}, momentum_of(b, inertia));
}

const std::string weightless = "gravity = [0, 0, 0]\n";
const std::string brick =
    "[body]\nmin = [4, 4.5, 4]\nmax = [6, 5, 5]\nmotion = \"free\"\nmass = 3\n";
const std::string skew = "inertia = [2, 2, 2.5, 0.5, 0, 0.3]\n";
constexpr double skew_tensor[3][3] = {{2, 0.5, 0}, {0.5, 2, 0.3}, {0, 0.3, 2.5}};

TEST_F(FreeBodies, SwingByTheirOwnInertiaAboutTheirOwnCentre) {
  World w(
      "[body]\nname = \"bar\"\nmin = [4.9, 4]\nmax = [5.1, 6]\nmotion = \"free\"\nmass = 2\n"
      "center_of_mass = [5, 5.5]\ninertia = 0.7\nangular_velocity = 0.1\nvelocity = [0.05, 0]\n"
      "[joint]\nbody = \"bar\"\npoint = [5, 6]\n");
  EXPECT_EQ(5.5, w[0].position[1]);
  const double period = 2 * std::numbers::pi * std::sqrt((0.7 + 2 * 0.25) / (2 * 9.81 * 0.5));
  EXPECT_NEAR(period / 2, half_period(w), 0.01 * period);
  EXPECT_NEAR(0.5, std::hypot(w[0].position[0] - 5, w[0].position[1] - 6), 1e-3)
      << "the bar left its hinge";
}

TEST_F(FreeBodies, RestWithTheirShapeOnTheFloor) {
  for (const bool flat : {true, false}) {
    World w(flat ? "[body]\nmin = [4, 0.01]\nmax = [5, 1.01]\nmotion = \"free\"\nmass = 500\n"
                   "restitution = 0\ncenter_of_mass = [4.5, 0.21]\ninertia = 80\n"
                 : "[body]\nmin = [4, 0.01, 4]\nmax = [5, 1.01, 6]\nmotion = \"free\"\nmass = 500\n"
                   "restitution = 0\ncenter_of_mass = [4.5, 0.21, 5]\ninertia = [200, 210, 80]\n",
            flat);
    w.run(1);
    EXPECT_NEAR(0.2, w[0].position[1], 5e-3) << flat;
    EXPECT_NEAR(1, w[0].orientation[3], 1e-3) << flat;
  }
}

TEST_F(FreeBodies, KeepTheirAngularMomentumOfAFullTensor) {
  World w(brick + skew + "angular_velocity = 2\nturn_axis = [1, 0, 0]\n", false, weightless);
  const Point3 before = momentum_of(w[0], skew_tensor);
  EXPECT_NEAR(1, before.y, 1e-12);
  w.run(1);
  const Point3 after = momentum_of(w[0], skew_tensor);
  EXPECT_LT(norm(after - before), 0.02 * norm(before));
  EXPECT_GT(std::abs(w[0].angular_velocity[1]), 0.05) << "x is no principal axis";
}

// Bullet and the solvers' inverse mass matrix must agree for each choice of locked axes.
TEST_F(FreeBodies, AnswerATorqueByTheirMobility) {
  const char* names[] = {"\"rotation_x\",", "\"rotation_y\",", "\"rotation_z\","};
  for (int locked = 0; locked < 8; ++locked) {
    std::string lock = "lock = [\"y\",";
    for (int k = 0; k < 3; ++k)
      if (locked >> k & 1) lock += names[k];
    World w(brick + skew + lock + "]\n", false, weightless);
    w.bodies().states()[0].orientation = rotation_by({0.3, -0.8, 0.5});
    const auto mobility = w.bodies().mobility(0);
    const SixNumbers force{1, 2, 3, 0.4, -0.5, 0.6};
    const double dt = 1e-3;
    w.bodies().step(0, dt, std::vector{force});
    for (std::size_t i = 0; i < 6; ++i) {
      double expected = 0;
      for (std::size_t j = 0; j < 6; ++j) expected += dt * mobility[i][j] * force[j];
      const double found = i < 3 ? w[0].velocity[i] : w[0].angular_velocity[i - 3];
      EXPECT_NEAR(expected, found, 1e-6 * dt) << "component " << i << " of " << lock;
      const bool holds = i == 1 || (i >= 3 && locked >> (i - 3) & 1);
      EXPECT_EQ(holds, found == 0) << "component " << i << " of " << lock;
    }
  }
}

// The constraint of a locked axis does no work, although the body precesses.
TEST_F(FreeBodies, KeepTheirEnergyWithALockedAxis) {
  World w(brick + skew + "lock = [\"rotation_z\"]\nangular_velocity = 2\nturn_axis = [1, 0, 0]\n",
          false, weightless);
  const double before = energy_of(w[0], skew_tensor);
  double turned = 0;
  for (int k = 0; k < 2000; ++k) {
    w.run(0.001);
    ASSERT_EQ(0, w[0].angular_velocity[2]);
    turned = std::max(turned, std::abs(w[0].angular_velocity[1]));
  }
  EXPECT_NEAR(before, energy_of(w[0], skew_tensor), 0.02 * before);
  EXPECT_GT(turned, 0.05);
}

TEST_F(FreeBodies, KeepTheBitsOfLockedCoordinatesIn2D) {
  World w(
      "[[body]]\nmin = [4.1, 0.7]\nmax = [5.3, 1.2]\nmotion = \"free\"\ndensity = 500\n"
      "lock = [\"x\", \"rotation_z\"]\n"
      "[[body]]\nshape = \"sphere\"\ncenter = [5.5, 3]\nradius = 0.5\nmotion = \"free\"\n"
      "density = 900\nvelocity = [-1, 0]\n");
  const BodyState before = w[0];
  w.run(1.5);
  EXPECT_EQ(before.position[0], w[0].position[0]);
  EXPECT_EQ(before.orientation, w[0].orientation);
  EXPECT_NEAR(0.25, w[0].position[1], 0.02) << "it falls to the floor";
  EXPECT_GT(std::abs(w[1].velocity[0] + 1), 0.01) << "the ball hit the box";
}

TEST_F(FreeBodies, KeepTheBitsOfLockedCoordinatesIn3D) {
  const std::string ball =
      "[[body]]\nshape = \"sphere\"\ncenter = [5.6, 3, 5.3]\nradius = 0.5\nmotion = \"free\"\n"
      "density = 900\nvelocity = [-1, 0, 0]\n";
  const std::string box =
      "[[body]]\nmin = [4.1, 0.7, 4]\nmax = [5.3, 1.2, 6]\nmotion = \"free\"\ndensity = 500\n";
  World one(box + "lock = [\"z\", \"rotation_x\", \"rotation_y\"]\n" + ball, false);
  const double z = one[0].position[2];
  one.run(1.5);
  EXPECT_EQ(z, one[0].position[2]);
  EXPECT_EQ(0, one[0].orientation[0]);
  EXPECT_EQ(0, one[0].orientation[1]);
  EXPECT_NE(0, one[0].orientation[2]) << "the ball turned it";
  World all(box + "lock = [\"x\", \"z\", \"rotation_x\", \"rotation_y\", \"rotation_z\"]\n" + ball,
            false);
  const BodyState before = all[0];
  all.run(1.5);
  EXPECT_EQ(before.position[0], all[0].position[0]);
  EXPECT_EQ(before.position[2], all[0].position[2]);
  EXPECT_EQ(before.orientation, all[0].orientation);
  EXPECT_NEAR(0.25, all[0].position[1], 0.02) << "it falls to the floor";
}

}  // namespace
}  // namespace freshet::test

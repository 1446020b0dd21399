// SPDX-License-Identifier: MIT
// Motion of bodies without forces from a fluid.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bodies/body_world.h"
#include "core/rotation.h"
#include "mesh/mesh_distance.h"
#include "scene/model/body_mesh.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

constexpr double pi = std::numbers::pi;

TEST_F(FreeBodies, FallFreely) {
  World w(
      "[body]\nmin = [4, 7]\nmax = [5, 8]\nmotion = \"free\"\ndensity = 500\n"
      "velocity = [1, 0]\nangular_velocity = 2\n");
  w.run(0.5);
  EXPECT_NEAR(5.0, w[0].position[0], 1e-9);
  EXPECT_NEAR(7.5 - 9.81 / 2 * 0.25, w[0].position[1], 9.81 * 0.5 * 0.001);
  EXPECT_NEAR(1.0, angle_of(w[0]), 1e-6);
  EXPECT_EQ(0, w[0].position[2]);
}

TEST_F(FreeBodies, KeepTheirAngularVelocityWithoutATorque) {
  World w(
      "[body]\nmin = [4, 7, 4]\nmax = [5, 7.5, 6]\nmotion = \"free\"\nmass = 3\n"
      "angular_velocity = 2\nturn_axis = [1, 0, 0]\n",
      false);
  w.run(0.5);
  EXPECT_NEAR(2.0, w[0].angular_velocity[0], 1e-6);
  EXPECT_NEAR(std::sin(0.5), w[0].orientation[0], 1e-6);
}

TEST_F(FreeBodies, ComeToRestOnTheFloor) {
  World w(
      "[body]\nmin = [4, 0.2]\nmax = [5, 1.2]\nmotion = \"free\"\ndensity = 500\n"
      "restitution = 0\n");
  w.run(2);
  EXPECT_NEAR(0.5, w[0].position[1], 1e-3);
  EXPECT_LT(std::abs(w[0].velocity[1]), 9.81 * 0.001) << "faster than one step of gravity";
  EXPECT_NEAR(0, angle_of(w[0]), 1e-3);
}

TEST_F(FreeBodies, BounceByTheirRestitution) {
  World w(
      "[body]\nshape = \"sphere\"\ncenter = [5, 3]\nradius = 0.5\nmotion = \"free\"\n"
      "mass = 1\nrestitution = 0.5\n");
  double fastest_up = 0;
  for (int k = 0; k < 1000; ++k) {
    w.run(0.001);
    fastest_up = std::max(fastest_up, w[0].velocity[1]);
  }
  EXPECT_NEAR(0.5 * std::sqrt(2 * 9.81 * 2.5), fastest_up, 0.05);
}

TEST_F(FreeBodies, CollideElastically) {
  World w(
      "[[body]]\nshape = \"sphere\"\ncenter = [3, 5]\nradius = 0.5\nmotion = \"free\"\n"
      "mass = 2\nvelocity = [1, 0]\nrestitution = 1\nfriction = 0\n"
      "[[body]]\nshape = \"sphere\"\ncenter = [4.5, 5]\nradius = 0.5\nmotion = \"free\"\n"
      "mass = 1\nrestitution = 1\nfriction = 0\n",
      true, "gravity = [0, 0]\n");
  w.run(2);
  EXPECT_NEAR(1.0 / 3, w[0].velocity[0], 1e-3);
  EXPECT_NEAR(4.0 / 3, w[1].velocity[0], 1e-3);
}

// Physical pendulum: a bar that hangs on its end has the period T = 2 pi sqrt(I/(m g L)), where I
// is its inertia about the hinge and L the distance of its centre from it.
TEST_F(FreeBodies, SwingOnAHingeWithThePeriodOfAPendulum) {
  World w(
      "[body]\nname = \"bar\"\nmin = [4.9, 4]\nmax = [5.1, 6]\nmotion = \"free\"\nmass = 1\n"
      "angular_velocity = 0.1\nvelocity = [0.1, 0]\n"
      "[joint]\nbody = \"bar\"\npoint = [5, 6]\n");
  const double inertia = 1.0 / 12 * (4 + 0.04) + 1, period = 2 * pi * std::sqrt(inertia / 9.81);
  double turned = 0;
  for (double t = 0; t < 4; t += 0.001) {
    w.run(0.001);
    if (t > 0.2 && turned == 0 && angle_of(w[0]) < 0) turned = t;  // half a period
  }
  EXPECT_NEAR(period / 2, turned, 0.01 * period);
  const double x = w[0].position[0] - 5, y = w[0].position[1] - 6;
  EXPECT_NEAR(1, std::hypot(x, y), 1e-3) << "the bar left its hinge";
}

TEST_F(FreeBodies, ReachTheSpeedOfTheirMotor) {
  for (const double speed : {3.0, -3.0}) {
    World w(
        "[body]\nname = \"wheel\"\nshape = \"sphere\"\ncenter = [5, 5]\nradius = 1\n"
        "motion = \"free\"\nmass = 2\n"
        "[joint]\nbody = \"wheel\"\npoint = [5, 5]\nmotor_speed = " +
        std::to_string(speed) + "\nmotor_torque = 2\n");
    w.run(0.5);  // inertia 1 kg m²: 2 rad/s²
    EXPECT_NEAR(std::copysign(1, speed), w[0].angular_velocity[2], 0.01);
    w.run(2);
    EXPECT_NEAR(speed, w[0].angular_velocity[2], 1e-6);
    EXPECT_NEAR(5, w[0].position[1], 1e-4);
  }
}

TEST_F(FreeBodies, AreCarriedByMovedBodies) {
  World w(
      "[[body]]\nmin = [3, 2]\nmax = [7, 3]\nmotion = \"moved\"\nposition = [\"0\", \"0.5*t*t\"]\n"
      "[[body]]\nmin = [4.5, 3.01]\nmax = [5.5, 4]\nmotion = \"free\"\ndensity = 100\n"
      "restitution = 0\n");
  w.run(1.5);
  EXPECT_NEAR(2.5 + 0.5 * 1.5 * 1.5, w[0].position[1], 1e-9);
  EXPECT_NEAR(w[0].position[1] + 0.5 + 0.495, w[1].position[1], 0.01);
  EXPECT_NEAR(1.5, w[1].velocity[1], 0.02);
}

TEST(MovedBodies, FollowTheirFunctions) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  World w(
      "[body]\nmin = [4, 4]\nmax = [6, 5]\nmotion = \"moved\"\n"
      "position = [\"0.3*sin(2*t)\", \"0\"]\nangle = \"90*t\"\npivot = [4, 4.5]\n");
  const double t = 0.7, a = pi / 2 * t;
  const BodyState b = w.bodies().at(0, t, 0);
  EXPECT_NEAR(4 + std::cos(a) + 0.3 * std::sin(2 * t), b.position[0], 1e-12);
  EXPECT_NEAR(4.5 + std::sin(a), b.position[1], 1e-12);
  EXPECT_NEAR(-pi / 2 * std::sin(a) + 0.6 * std::cos(2 * t), b.velocity[0], 1e-9);
  EXPECT_NEAR(pi / 2 * std::cos(a), b.velocity[1], 1e-9);
  EXPECT_NEAR(pi / 2, b.angular_velocity[2], 1e-9);
}

TEST(MovedBodies, PassTheirKeyFrames) {
  const std::string frames =
      "[[body.key]]\ntime = 0\n[[body.key]]\ntime = 1\ntranslation = [1, 0]\nangle = 30\n"
      "[[body.key]]\ntime = 3\ntranslation = [0, 1]\n";
  const std::string body = "[body]\nmin = [4, 4]\nmax = [6, 5]\nmotion = \"moved\"\n";
  for (const char* how : {"smooth", "linear"}) {
    World w(body + "interpolation = \"" + how + "\"\n" + frames);
    for (const auto& [time, x] : {std::pair{0.0, 5.0}, {1.0, 6.0}, {3.0, 5.0}, {9.0, 5.0}})
      EXPECT_NEAR(x, w.bodies().at(0, time, 0).position[0], 1e-12) << how << time;
    for (const double t : {0.3, 0.9, 1.4, 2.9}) {  // velocities are the derivatives of positions
      const auto at = [&](double s) { return w.bodies().at(0, s, 0); };
      EXPECT_NEAR((at(t + 1e-5).position[0] - at(t - 1e-5).position[0]) / 2e-5, at(t).velocity[0],
                  1e-8);
      EXPECT_NEAR((angle_of(at(t + 1e-5)) - angle_of(at(t - 1e-5))) / 2e-5,
                  at(t).angular_velocity[2], 1e-8);
    }
  }
  World smooth(body + frames), linear(body + "interpolation = \"linear\"\n" + frames);
  EXPECT_NEAR(0, smooth.bodies().at(0, 1e-9, 0).velocity[0], 1e-6)
      << "a smooth motion must start at rest";
  EXPECT_NEAR(1, linear.bodies().at(0, 1e-9, 0).velocity[0], 1e-12);
}

TEST(BodyShapes, HaveExactInertiaAndAClosedMesh) {
  const Scene boxes = scene_of("[body]\nmin = [4, 4, 4]\nmax = [5, 6, 7]\n", false);
  const BodyShape box = body_shape(boxes.body[0]);
  EXPECT_NEAR(6, box.volume, 1e-12);
  EXPECT_NEAR(6 * (4 + 9) / 12.0, box.inertia[0][0], 1e-12);
  EXPECT_NEAR(6 * (1 + 9) / 12.0, box.inertia[1][1], 1e-12);
  const Scene others = scene_of(
      "[[body]]\nshape = \"cylinder\"\ncenter = [3, 3, 3]\nradius = 1\nlength = 2\n"
      "axis = [1, 1, 0]\n[[body]]\nshape = \"sphere\"\ncenter = [6, 6, 6]\nradius = 1\n",
      false);
  for (const Scene::Body& b : others.body) {
    const BodyShape exact = body_shape(b);
    TriangleMesh mesh = body_mesh(b);
    EXPECT_TRUE(mend_mesh(mesh).closed());
    const MeshDistance surface(mesh);
    EXPECT_LT(surface.signed_distance(exact.center), -0.9) << "the mesh must face outwards";
    EXPECT_NEAR(exact.reach, norm(surface.high() - exact.center), 1.0);
  }
  const BodyShape rod = body_shape(others.body[0]);
  const double along = pi * 2 * 0.5, across = pi * 2 * (0.25 + 4.0 / 12);
  EXPECT_NEAR(along + across, rod.inertia[0][0] + rod.inertia[1][1], 1e-9);
  EXPECT_NEAR(across, rod.inertia[2][2], 1e-9);
  EXPECT_NEAR((along - across) / 2, rod.inertia[0][1], 1e-9);
}

}  // namespace
}  // namespace freshet::test

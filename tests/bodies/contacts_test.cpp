// SPDX-License-Identifier: MIT
// Bodies at rest on sides, walls and other bodies, and contacts across periodic ends.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "bodies/body_world.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

double norm_of(const std::array<double, 3>& a) { return std::hypot(a[0], a[1], a[2]); }

/// The cosine of the angle between a body and its start.
double upright(const BodyState& b) { return std::abs(b.orientation[3]); }

std::string box(double x, double y, double size, bool flat, const std::string& more = "") {
  return fmt::format(
      "[[body]]\nmin = [{:.17g}, {:.17g}{}]\nmax = [{:.17g}, {:.17g}{}]\nmotion = \"free\"\n"
      "density = 500\n{}",
      x, y, flat ? "" : ", 4.2", x + size, y + size, flat ? "" : fmt::format(", {}", 4.2 + size),
      more);
}

class RestingBodies : public FreeBodies {};

TEST_F(RestingBodies, StackOfTenStaysAtRest) {
  for (const bool flat : {true, false}) {
    std::string stack;
    for (int k = 0; k < 10; ++k)
      stack += box(4 + 0.1 * (k % 2), 0.002 + 0.902 * k, 0.9, flat, "restitution = 0\n");
    World w(stack, flat);
    w.run(1, 0.005);
    std::vector<BodyState> settled;
    for (std::size_t k = 0; k < 10; ++k) settled.push_back(w[k]);
    w.run(10, 0.005);
    for (std::size_t k = 0; k < 10; ++k) {
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(settled[k].position[d], w[k].position[d], 1e-4) << k << " " << d;
      EXPECT_NEAR(0.45 + 0.9 * double(k), w[k].position[1], 1e-3) << k;
      EXPECT_NEAR(1, upright(w[k]), 1e-6) << k;
      EXPECT_LT(norm_of(w[k].velocity), 1e-3) << k;
      EXPECT_LT(norm_of(w[k].angular_velocity), 1e-3) << k;
    }
  }
}

// Each shape is put down on each kind of wall and body, and must lie still.
struct Support {
  const char* name;
  std::string text;
  double top;
};
class EachSupport : public FreeBodies, public ::testing::WithParamInterface<Support> {};
void PrintTo(const Support& s, std::ostream* out) { *out << s.name; }

const std::string box_obj =
    "shape = \"mesh\"\nfile = \"" SOURCE_DIR "/tests/scenes/meshes/box.obj\"\nscale = 2.5\n";
const std::string fixed_box = "min = [3, 0.5, 3]\nmax = [7, 1, 7]\n";
const std::string disc =
    "shape = \"cylinder\"\ncenter = [5, 0.5, 5]\naxis = [0, 1, 0]\nradius = 2\nlength = 1\n";
INSTANTIATE_TEST_SUITE_P(
    RestingBodies, EachSupport,
    ::testing::Values(
        Support{"side", "", 0},
        Support{"plane",
                "[[wall]]\nshape = \"plane\"\npoint = [0, 1, 0]\n"
                "normal = [0, 1, 0]\n",
                1},
        Support{"tank",
                "[[wall]]\nside = \"inside\"\nmin = [1, 1, 1]\n"
                "max = [10, 10, 10]\n",
                1},
        Support{"wall_box", "[[wall]]\n" + fixed_box, 1},
        Support{"wall_cylinder", "[[wall]]\n" + disc, 1},
        Support{"wall_mesh", "[[wall]]\n" + box_obj + "translation = [5, 0.5, 5]\n", 1},
        Support{"fixed_box", "[[body]]\n" + fixed_box, 1},
        Support{"fixed_cylinder", "[[body]]\n" + disc, 1},
        Support{"fixed_mesh", "[[body]]\n" + box_obj + "translation = [5, 0.5, 5]\n", 1},
        Support{"free_box",
                "[[body]]\nmotion = \"free\"\ndensity = 900\n"
                "min = [3, 0, 3]\nmax = [7, 1, 7]\n",
                1}),
    [](const auto& support) { return support.param.name; });

TEST_P(EachSupport, HoldsEveryShapeStill) {
  const double y = GetParam().top + 0.01;
  const std::pair<std::string, double> shapes[] = {
      {fmt::format("min = [4.8, {}, 4.7]\nmax = [5.2, {}, 5.3]\n", y, y + 0.4), 0.2},
      {fmt::format("shape = \"sphere\"\ncenter = [5, {}, 5]\nradius = 0.2\n", y + 0.2), 0.2},
      {fmt::format("shape = \"cylinder\"\ncenter = [5, {}, 5]\naxis = [0, 1, 0]\nradius = 0.2\n"
                   "length = 0.4\n",
                   y + 0.2),
       0.2},
      {fmt::format("shape = \"cylinder\"\ncenter = [5, {}, 5]\naxis = [1, 0, 0]\nradius = 0.2\n"
                   "length = 0.6\n",
                   y + 0.2),
       0.2},
      {fmt::format("shape = \"mesh\"\nfile = \"" SOURCE_DIR
                   "/tests/scenes/meshes/box.obj\"\ntranslation = [5, {}, 5]\n",
                   y + 0.2),
       0.2}};
  for (const auto& [shape, half] : shapes) {
    World w("[[body]]\nmotion = \"free\"\ndensity = 500\n" + shape + GetParam().text, false);
    w.run(2, 0.004);
    const BodyState settled = w[0];
    w.run(2, 0.004);
    // A cylinder on a mesh, or on its side on a box, touches in a few points of its round edges,
    // and rolls a little.
    const bool rolls = shape.find("cylinder") != shape.npos;
    EXPECT_NEAR(GetParam().top + half, w[0].position[1], 1e-3) << shape;
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(settled.position[d], w[0].position[d], rolls ? 1e-2 : 1e-4) << shape << d;
    EXPECT_NEAR(1, upright(w[0]), rolls ? 1e-2 : 1e-4) << shape;
    EXPECT_LT(norm_of(w[0].velocity), rolls ? 0.05 : 1e-3) << shape;
    EXPECT_LT(norm_of(w[0].angular_velocity), rolls ? 0.25 : 1e-3) << shape;
  }
}

// A box lands on an edge, falls over and then lies still on a face.
TEST_F(RestingBodies, TumblingBoxComesToRest) {
  for (const bool flat : {true, false}) {
    World w(
        box(4, 0.5, 1, flat,
            std::string("angular_velocity = 3\n") + (flat ? "" : "turn_axis = [0.3, 0.2, 1.0]\n")),
        flat);
    w.run(4, 0.004);
    const BodyState settled = w[0];
    w.run(2, 0.004);
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_NEAR(settled.position[d], w[0].position[d], 1e-4) << d;
    EXPECT_NEAR(0.5, w[0].position[1], 1e-3);
    EXPECT_LT(norm_of(w[0].angular_velocity), 2e-3);
  }
}

// Slope of 20 degrees: friction holds a box if its coefficient exceeds tan 20° = 0.364; otherwise
// the box slides down with g (sin 20° - mu cos 20°).
TEST_F(RestingBodies, FrictionHoldsThemOnASlope) {
  const double angle = 20 * M_PI / 180, t = 1;
  const auto slid = [&](double friction, bool flat) {
    const std::string z = flat ? "" : ", 0";
    const std::string gravity = fmt::format("gravity = [{:.17g}, {:.17g}{}]\n",
                                            9.81 * std::sin(angle), -9.81 * std::cos(angle), z);
    World w(box(3, 0, 1, flat, fmt::format("restitution = 0\nfriction = {}\n", friction)), flat,
            gravity);
    w.run(t, 0.002);
    return w[0].position[0] - 3.5;
  };
  for (const bool flat : {true, false}) {
    EXPECT_NEAR(0, slid(0.4, flat), 2e-3);
    EXPECT_NEAR(9.81 * (std::sin(angle) - 0.2 * std::cos(angle)) / 2, slid(0.2, flat), 0.01);
  }
}

const std::string weightless_row = "gravity = [0, 0]\nperiodic = \"x\"\n";

class PeriodicBodies : public FreeBodies {};

std::string pair_of_balls(double x) {
  return fmt::format(
      "[[body]]\nshape = \"sphere\"\ncenter = [{:.17g}, 5]\nradius = 0.5\nmotion = \"free\"\n"
      "mass = 2\nvelocity = [1, 0]\nrestitution = 1\nangular_velocity = 2\n"
      "[[body]]\nshape = \"sphere\"\ncenter = [{:.17g}, 5.2]\nradius = 0.5\nmotion = \"free\"\n"
      "mass = 1\nrestitution = 1\n",
      x, x < 8 ? x + 1.5 : x - 8.5);
}

// The same collision within the domain and across its seam.
TEST_F(PeriodicBodies, CollideAcrossTheSeamAsElsewhere) {
  World within(pair_of_balls(3), true, weightless_row),
      across(pair_of_balls(9), true, weightless_row);
  within.run(2);
  across.run(2);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_GT(std::abs(within[k].velocity[1]), 0.1) << "they must collide";
    for (std::size_t d = 0; d < 2; ++d)
      EXPECT_NEAR(within[k].velocity[d], across[k].velocity[d], 1e-9) << k << d;
    EXPECT_NEAR(within[k].angular_velocity[2], across[k].angular_velocity[2], 1e-9) << k;
    EXPECT_NEAR(within[k].position[0] + (k == 0 ? 6 : -4), across[k].position[0], 1e-9) << k;
  }
  EXPECT_NEAR(2, 2 * across[0].velocity[0] + across[1].velocity[0], 1e-12);
  EXPECT_NEAR(0, 2 * across[0].velocity[1] + across[1].velocity[1], 1e-12);
}

// Positions of bodies are not wrapped: one that has gone round twice still meets the other.
TEST_F(PeriodicBodies, CollideAfterSeveralPeriods) {
  World w(
      "[[body]]\nmin = [1, 4.5]\nmax = [2, 5.5]\nmotion = \"free\"\nmass = 1\n"
      "velocity = [10, 0]\nrestitution = 1\n"
      "[[body]]\nmin = [5, 7]\nmax = [6, 8]\nmotion = \"free\"\nmass = 1\n"
      "velocity = [0, -0.7]\nrestitution = 1\n[walls]\nmethod = \"open\"\n",
      true, weightless_row);
  w.run(2);
  EXPECT_DOUBLE_EQ(10, w[0].velocity[0]) << "they must not meet before";
  w.run(2);
  EXPECT_LT(w[0].velocity[1], -0.1) << "they must meet";
  EXPECT_NEAR(10, w[0].velocity[0] + w[1].velocity[0], 1e-12);
  EXPECT_NEAR(-0.7, w[0].velocity[1] + w[1].velocity[1], 1e-12);
}

TEST_F(PeriodicBodies, BounceOffWallsBeyondTheSeam) {
  for (const std::string& wall :
       {std::string("[[wall]]\nmin = [0.2, 3]\nmax = [1, 7]\n"),
        std::string("[[wall]]\nmin = [10.2, 3]\nmax = [11, 7]\n"),
        std::string("[[wall]]\nshape = \"sphere\"\ncenter = [0.7, 5]\nradius = 0.5\n"),
        std::string("[[body]]\nmin = [0.2, 3]\nmax = [1, 7]\n")}) {
    World w(
        "[[body]]\nshape = \"sphere\"\ncenter = [9, 5]\nradius = 0.5\nmotion = \"free\"\n"
        "mass = 1\nvelocity = [1, 0]\nrestitution = 1\n" +
            wall,
        true, weightless_row);
    w.run(1.4);
    EXPECT_NEAR(wall.find("body") == wall.npos ? -1 : -0.3, w[0].velocity[0], 1e-5) << wall;
    EXPECT_NEAR(0, w[0].velocity[1], 1e-9) << wall;
  }
}

TEST_F(PeriodicBodies, BounceOffMeshesBeyondTheSeam) {
  World w(
      "[[body]]\nshape = \"sphere\"\ncenter = [9, 5, 5]\nradius = 0.5\nmotion = \"free\"\n"
      "mass = 1\nvelocity = [1, 0, 0]\nrestitution = 1\n"
      "[[wall]]\n" +
          box_obj + "translation = [0.7, 5, 5]\n",
      false, "gravity = [0, 0, 0]\nperiodic = \"x\"\n");
  w.run(1.4);
  EXPECT_NEAR(-1, w[0].velocity[0], 1e-5);
}

// A box slides without friction over floors that end at the seam, several times around.
TEST_F(PeriodicBodies, SlideOverTheSeam) {
  for (const std::string& floor :
       {std::string(""), std::string("[[wall]]\nmin = [0, 0]\nmax = [10, 1]\n"),
        std::string("[[wall]]\nmin = [-1, 0]\nmax = [11, 1]\n"),
        std::string("[[body]]\nmin = [0, 0]\nmax = [10, 1]\n"),
        std::string("[[body]]\nmin = [0, 0]\nmax = [10, 1]\nmotion = \"moved\"\n"
                    "position = [\"3*t\", \"0\"]\n")}) {
    if (floor.find("3*t") != floor.npos && !reads_expressions()) continue;
    const double y = floor.empty() ? 0 : 1;
    for (const double vx : {7.0, -7.0}) {
      World w(box(4, y, 1, true,
                  fmt::format("restitution = 0\nfriction = 0\nvelocity = [{}, 0]\n", vx)) +
                  floor,
              true, "periodic = \"x\"\n");
      w.run(8, 0.002);
      EXPECT_NEAR(vx, w[0].velocity[0], 1e-9) << floor;
      EXPECT_NEAR(4.5 + 8 * vx, w[0].position[0], 1e-6) << floor;
      EXPECT_NEAR(y + 0.5, w[0].position[1], 1e-3) << floor;
      EXPECT_NEAR(1, upright(w[0]), 1e-9) << floor;
    }
  }
}

// The step depends on nothing but the states: copied to a fresh world, they have the same future.
TEST_F(PeriodicBodies, ContinueFromTheirStatesToTheSameBits) {
  const std::string bodies = box(9.4, 0.3, 1, true, "angular_velocity = 1\n") +
                             box(0.2, 1.5, 1, true, "velocity = [-1, 0]\n") +
                             box(9.7, 3, 0.8, true, "friction = 1\n");
  World first(bodies, true, "periodic = \"x\"\n"), second(bodies, true, "periodic = \"x\"\n");
  first.run(1);
  second.bodies().states() = first.bodies().states();
  first.run(1);
  second.run(1);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(first[k].position, second[k].position);
    EXPECT_EQ(first[k].orientation, second[k].orientation);
    EXPECT_EQ(first[k].velocity, second[k].velocity);
    EXPECT_EQ(first[k].angular_velocity, second[k].angular_velocity);
  }
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
// The body particles of small balls.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/model/setup.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

Scene with_body(const std::string& body, const std::string& solver = "dfsph") {
  return with_defaults(scene_with("[1, 1, 1]", 0.02,
                                  "solver.name = \"" + solver +
                                      "\"\n[fluid]\nmin = [0, 0, 0]\nmax = [0.1, 0.1, 0.1]\n"
                                      "[[body]]\n" +
                                      body));
}
std::string ball(double spacings) {
  return "shape = \"sphere\"\ncenter = [0.5, 0.5, 0.5]\nradius = " +
         std::to_string(0.02 * spacings) + "\n";
}
/// The depth of the body particles beneath the surface of a ball [spacings].
double depth(const Scene& s, double radius) {
  const auto& x = sample(s).bodies.x;
  return radius - std::hypot(x[0] - 0.5, x[1] - 0.5, x[2] - 0.5) / 0.02;
}

// At the depth of a flat layer, a ball of 1.5 spacings has 83 % of its buoyancy.
TEST(BallLayer, IsHigherTheSmallerTheBall) {
  const double flat = single_layer_distance(with_body(ball(3))) / 0.02 - 0.5;
  double before = 0;
  for (const double radius : {1.5, 2.0, 3.0, 6.0}) {
    const double now = depth(with_body(ball(radius)), radius);
    EXPECT_GT(now, before) << radius;
    EXPECT_LT(now, flat) << radius;
    before = now;
  }
  EXPECT_NEAR(flat, depth(with_body(ball(14)), 14), 1e-9);
}

// The other solvers and other shapes keep the flat layer.
TEST(BallLayer, IsOfBallsInPressureSolvers) {
  const Scene explicit_scheme = with_body(ball(2), "wcsph\"\nwalls.method = \"akinci2012");
  EXPECT_NEAR(single_layer_distance(explicit_scheme) / 0.02 - 0.5, depth(explicit_scheme, 2), 1e-9);
  const auto count = [](const Scene& s) { return double(sample(s).bodies.body.size()); };
  for (const double radius : {1.0, 1.5, 3.0, 11.9, 12.0})
    EXPECT_LE(count(with_body(ball(radius))), most_body_samples(with_body(ball(radius))));
}

}  // namespace
}  // namespace freshet::test

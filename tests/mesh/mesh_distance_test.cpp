// SPDX-License-Identifier: MIT
#include "mesh/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh/meshes.h"

namespace freshet::test {
namespace {

class Anywhere {
 public:
  Point operator()(double reach) {
    std::uniform_real_distribution<double> in(-reach, reach);
    return {in(generator_), in(generator_), in(generator_)};
  }

 private:
  std::mt19937 generator_{7};
};

/// Signed distance to a box about the origin.
double distance_to_box(Point x, Point half) {
  double beyond2 = 0, deepest = -1e9;
  for (int k = 0; k < 3; ++k) {
    const double q = std::abs(component(x, k)) - component(half, k);
    deepest = std::max(deepest, q);
    beyond2 += std::max(q, 0.0) * std::max(q, 0.0);
  }
  return deepest > 0 ? std::sqrt(beyond2) : deepest;
}

TEST(MeshDistance, OfABoxIsExact) {
  const Point half{1, 0.5, 0.2};
  const MeshDistance mesh(box_mesh(-1 * half, half));
  Anywhere anywhere;
  for (int k = 0; k < 2000; ++k) {
    const Point x = anywhere(1.5);
    EXPECT_NEAR(distance_to_box(x, half), mesh.signed_distance(x), 1e-12);
  }
  EXPECT_NEAR(2 * (2 * 1 + 1 * 0.4 + 0.4 * 2), mesh.area(), 1e-12);
}

TEST(MeshDistance, OfABallMatchesSolidAnglesAndRadius) {
  TriangleMesh ball = ball_mesh(1, 4);
  const MeshDistance mesh(ball);
  Anywhere anywhere;
  for (int k = 0; k < 200; ++k) {
    const Point x = anywhere(1.5);
    double all = 0;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t)
      all += solid_angle(ball.corners(int(t)), x);
    EXPECT_NEAR(all, mesh.winding_number(x), 0.04);
    EXPECT_NEAR(norm(x) - 1, mesh.signed_distance(x), 0.01);
  }
}

TEST(MeshDistance, FindsTheInsideDespiteASmallHole) {
  TriangleMesh ball = ball_mesh(1, 3);
  ball.triangles.erase(ball.triangles.begin() + 100, ball.triangles.begin() + 104);
  const MeshDistance mesh(ball);
  Anywhere anywhere;
  for (int k = 0; k < 500; ++k) {
    const Point x = anywhere(1.5);
    EXPECT_TRUE(std::abs(norm(x) - 1) < 0.2 || mesh.is_inside(x) == (norm(x) < 1));
  }
}

TEST(MeshDistance, FindsTheFirstHitOfARay) {
  const MeshDistance mesh(box_mesh({0, 0, 0}, {1, 1, 1}));
  EXPECT_NEAR(2, mesh.first_hit({-2, 0.3, 0.4}, {1, 0, 0}, 0).value(), 1e-12);
  EXPECT_NEAR(1, mesh.first_hit({0, 0.3, 0.4}, {1, 0, 0}, 1e-6).value(), 1e-12);
  EXPECT_FALSE(mesh.first_hit({-2, 1.3, 0.4}, {1, 0, 0}, 0).has_value());
}

}  // namespace
}  // namespace freshet::test

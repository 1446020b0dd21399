// SPDX-License-Identifier: MIT
#include "scene/sample/mesh_surface.h"

#include <gtest/gtest.h>

#include "mesh/meshes.h"

namespace freshet::test {
namespace {

double nearest(const std::vector<Point>& all, Point x, const Point* but = nullptr) {
  double least = 1e9;
  for (const Point& p : all)
    if (&p != but) least = std::min(least, norm(p - x));
  return least;
}

TEST(MeshSurface, IsSampledEvenlyAtItsDepth) {
  const double spacing = 0.1;
  const MeshDistance ball(ball_mesh(1, 4));
  for (const double depth : {0.05, 0.0, -0.05}) {
    const auto all = points_behind(ball, spacing, depth);
    const double apart = depth == 0 ? 0.5 : 0.7;  // in sheets they are closer
    const double r = 1 - depth, per_square = double(all.size()) * spacing * spacing;
    EXPECT_NEAR(0.64, apart * apart * per_square / (4 * 3.14159 * r * r), 0.05) << depth;
    for (const Point& p : all) {
      EXPECT_NEAR(r, norm(p), 0.01);
      EXPECT_GE(nearest(all, p, &p), apart * spacing);
    }
    for (const Point& p : ball_mesh(r, 4).points)
      EXPECT_LT(nearest(all, p), 0.8 * spacing) << "a hole at depth " << depth;
  }
}

TEST(MeshSurface, KeepsItsDepthAtEdges) {
  const MeshDistance box(box_mesh({0, 0, 0}, {1, 1, 1}));
  for (const double depth : {0.05, -0.05})
    for (const Point& p : points_behind(box, 0.1, depth))
      EXPECT_NEAR(-depth, box.signed_distance(p), 0.05 * 0.06);
}

TEST(MeshSurface, HasLayersAsDenseAsALattice) {
  const double spacing = 0.1;
  const auto all = layers_behind(MeshDistance(ball_mesh(1, 4)), spacing, 3, false);
  for (int layer = 0; layer < 3; ++layer) {
    const double r = 1 - (layer + 0.5) * spacing;
    const auto count = std::count_if(all.begin(), all.end(), [&](const Point& p) {
      return std::abs(norm(p) - r) < 0.1 * spacing;
    });
    EXPECT_NEAR(1, double(count) * spacing * spacing / (4 * 3.14159 * r * r), 0.04) << layer;
  }
  const auto plate =
      layers_behind(MeshDistance(box_mesh({0, 0, 0}, {1, 1, 0.2})), spacing, 3, false);
  EXPECT_NEAR(200, double(plate.size()), 20) << "room for one layer behind each face";
}

TEST(MeshSurface, OfAThinPlateIsSampledInItsMiddle) {
  const MeshDistance plate(box_mesh({0, 0, 0}, {1, 1, 0.04}));
  const auto all = points_behind(plate, 0.1, 0.05);
  EXPECT_GT(all.size(), 100u);
  for (const Point& p : all) EXPECT_NEAR(0.02, p.z, 1e-9);
  for (double x = 0.05; x < 1; x += 0.05)
    for (double y = 0.05; y < 1; y += 0.05) EXPECT_LT(nearest(all, {x, y, 0.02}), 0.1);
}

}  // namespace
}  // namespace freshet::test

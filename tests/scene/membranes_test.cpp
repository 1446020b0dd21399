// SPDX-License-Identifier: MIT
#include "scene/sample/membranes.h"

#include <gtest/gtest.h>

#include "scene/sample/join_points.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

TEST(JoinPoints, JoinsNeighboursOfALine) {
  const TriangleMesh mesh = join_points({0, 0, 1, 0, 2, 0.5, 5, 0}, 2, 1);
  EXPECT_EQ(4u, mesh.triangles.size()) << "two strips of two triangles; the last point is apart";
}

TEST(JoinPoints, CoversALatticeWithoutGaps) {
  std::vector<double> x;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      for (const double c : {double(a), 0.0, double(b)}) x.push_back(c);
  const MeshDistance membrane(join_points(x, 3, 1));
  for (double a = 0.05; a < 3; a += 0.1)
    for (double b = 0.05; b < 3; b += 0.1)
      EXPECT_TRUE(membrane.first_crossing({a, 0.3, b}, {a, -0.3, b})) << a << ", " << b;
  EXPECT_FALSE(membrane.first_crossing({1.5, 0.3, 1.5}, {1.5, 0.1, 1.5})) << "it stays above";
  EXPECT_FALSE(membrane.first_crossing({3.2, 0.3, 1.5}, {3.2, -0.3, 1.5})) << "beyond the edge";
}

TEST(JoinPoints, CutsNoCorners) {
  const TriangleMesh line = join_points({1, 0, 0, 0, 0, 1}, 2, 1);
  EXPECT_EQ(4u, line.triangles.size()) << "no strip across the corner";
  std::vector<double> x;
  for (const int corner : {0, 1, 2, 3})
    for (const int k : {1, 2, 3}) x.push_back(corner == k);
  const MeshDistance corner(join_points(x, 3, 1));
  EXPECT_FALSE(corner.first_crossing({1, 1, 1}, {0.2, 0.2, 0.2}));
  EXPECT_TRUE(corner.first_crossing({1, 1, 1}, {-0.2, -0.1, -0.2})) << "but the corner is closed";
}

TEST(JoinPoints, LeavesGapsThatLiquidFitsThrough) {
  EXPECT_TRUE(join_points({0, 0, 0, 2, 0, 0, 0, 0, 2}, 3, 1).triangles.empty());
  EXPECT_TRUE(join_points({0, 0, 0}, 3, 1).triangles.empty());
}

TEST(FirstCrossing, HoldsAtEdgesAndCorners) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const MeshDistance square(std::move(mesh));
  for (const double at : {0.0, 0.1, 0.3, 0.7, 1.0}) {
    EXPECT_TRUE(square.first_crossing({at, 1, at}, {at, -1, at})) << "on the diagonal, at " << at;
    EXPECT_TRUE(square.first_crossing({at, 1e-9, 0}, {at, 0, 0})) << "onto an edge";
  }
  const auto crossing = square.first_crossing({0.5, -1, 0.2}, {0.5, 3, 0.2});
  ASSERT_TRUE(crossing);
  EXPECT_DOUBLE_EQ(0.25, crossing->along);
  EXPECT_FALSE(square.first_crossing({0.5, 0, 0.2}, {0.5, -1, 0.2})) << "it starts on the square";
}

TEST(Membranes, AreTheThinPartsOfSolids) {
  const auto count = [](const char* walls) {
    const Scene scene = with_defaults(scene_with(
        "[1, 1]", 0.05,
        std::string("solver.name = \"dfsph\"\nfluid = { min = [0, 0], max = [0.2, 0.2] }\n") +
            walls));
    std::size_t triangles = 0;
    for (const Membrane& m : membranes_of(scene, 0.2))
      triangles += m.surface.mesh().triangles.size();
    return triangles;
  };
  EXPECT_EQ(0u, count("[[wall]]\nmin = [0.4, 0.4]\nmax = [0.7, 0.7]\n"));
  // sides of 0.4 m in pieces of 0.2 m, two triangles each, on both sides of the plate
  EXPECT_EQ(8u, count("[[wall]]\nmin = [0.4, 0.4]\nmax = [0.8, 0.45]\n"));
  EXPECT_EQ(8u, count("[[body]]\nmin = [0.4, 0.4]\nmax = [0.8, 0.45]\n"));
  EXPECT_EQ(0u, count("[[wall]]\nmin = [0.4, 0.4]\nmax = [0.8, 0.45]\nmethod = \"reflection\"\n"));
}

}  // namespace
}  // namespace freshet::test

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/mesh_distance.h"
#include "mesh/meshes.h"

namespace freshet::test {
namespace {

/// The enclosed volume; positive if the triangles face outwards.
double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(int(k));
    sum += dot(a, cross(b, c)) / 6;
  }
  return sum;
}

const Point low{1, 2, 3}, high{2, 4, 6};

TEST(MendMesh, KeepsAClosedMesh) {
  TriangleMesh mesh = box_mesh(low, high);
  const auto before = mesh.triangles;
  const MeshCondition c = mend_mesh(mesh);
  EXPECT_EQ(before, mesh.triangles);
  EXPECT_TRUE(c.closed());
  EXPECT_EQ(0, c.merged + c.degenerate + c.doubled + c.turned + c.crowded);
  EXPECT_NEAR(6, volume(mesh), 1e-12);
}

TEST(MendMesh, MergesCoincidentPoints) {
  TriangleMesh soup;
  const TriangleMesh box = box_mesh(low, high);
  for (std::size_t k = 0; k < box.triangles.size(); ++k) {
    for (Point p : box.corners(int(k))) {
      p.x += 1e-8 * double(k);  // closer than the distance at which points are merged
      soup.points.push_back(p);
    }
    const int n = int(soup.points.size());
    soup.triangles.push_back({n - 3, n - 2, n - 1});
  }
  const MeshCondition c = mend_mesh(soup);
  EXPECT_EQ(8u, soup.points.size());
  EXPECT_EQ(28, c.merged);
  EXPECT_TRUE(c.closed());
  EXPECT_NEAR(6, volume(soup), 1e-6);
}

TEST(MendMesh, FlipsTrianglesThatFaceTheOtherWay) {
  TriangleMesh mesh = ball_mesh(1, 2);
  const double whole = volume(mesh);
  std::int64_t turned = 0;
  for (std::size_t k = 0; k < mesh.triangles.size(); k += 5, ++turned)
    std::swap(mesh.triangles[k][0], mesh.triangles[k][1]);
  const MeshCondition c = mend_mesh(mesh);
  EXPECT_EQ(turned, c.turned);
  EXPECT_DOUBLE_EQ(whole, volume(mesh));
}

TEST(MendMesh, FlipsAShellThatIsInsideOut) {
  TriangleMesh mesh = box_mesh(low, high);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(12, mend_mesh(mesh).turned);
  EXPECT_NEAR(6, volume(mesh), 1e-12);
}

TEST(MendMesh, KeepsACavityInsideAShell) {
  TriangleMesh mesh = box_mesh(low, high), hollow = box_mesh({1.2, 2.2, 3.2}, {1.8, 3.8, 5.8});
  for (auto t : hollow.triangles) mesh.triangles.push_back({t[1] + 8, t[0] + 8, t[2] + 8});
  mesh.points.insert(mesh.points.end(), hollow.points.begin(), hollow.points.end());
  EXPECT_EQ(0, mend_mesh(mesh).turned);
  const MeshDistance distance(mesh);
  EXPECT_FALSE(distance.is_inside({1.5, 3, 4.5}));
  EXPECT_TRUE(distance.is_inside({1.1, 3, 4.5}));
}

TEST(MendMesh, RemovesDegenerateAndDuplicateTriangles) {
  TriangleMesh mesh = box_mesh(low, high);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({1, 0, 2});
  const MeshCondition c = mend_mesh(mesh);
  EXPECT_EQ(1, c.degenerate);
  EXPECT_EQ(1, c.doubled);
  EXPECT_EQ(12u, mesh.triangles.size());
  EXPECT_TRUE(c.closed());
}

TEST(MendMesh, CountsOpenAndCrowdedEdges) {
  TriangleMesh mesh = box_mesh(low, high);
  mesh.triangles.pop_back();  // a triangle of the face x = 2
  const MeshCondition c = mend_mesh(mesh);
  EXPECT_EQ(3, c.open);
  ASSERT_EQ(1u, c.holes.size());
  EXPECT_EQ(3, c.holes[0].edges);
  EXPECT_EQ(2, c.holes[0].middle.x);
  EXPECT_FALSE(c.holes[0].filled);
  mesh = box_mesh(low, high);
  mesh.points.push_back({1.5, 3, 9});
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_EQ(1, mend_mesh(mesh).crowded);
}

/// A ball without some of its triangles.
TriangleMesh holed_ball(std::initializer_list<int> missing) {
  TriangleMesh ball = ball_mesh(1, 3), mesh{ball.points, {}};
  for (int t = 0; t < int(ball.triangles.size()); ++t)
    if (std::find(missing.begin(), missing.end(), t) == missing.end())
      mesh.triangles.push_back(ball.triangles[std::size_t(t)]);
  return mesh;
}

TEST(MendMesh, FillsNarrowHoles) {
  TriangleMesh mesh = holed_ball({5, 200, 203, 400});
  const TriangleMesh ball = ball_mesh(1, 3);
  const MeshCondition c = mend_mesh(mesh, 0.3);
  EXPECT_TRUE(c.closed());
  ASSERT_EQ(3u, c.holes.size());
  EXPECT_EQ(4, c.holes[0].edges) << "two triangles side by side";
  for (const MeshHole& hole : c.holes) {
    EXPECT_TRUE(hole.filled);
    EXPECT_NEAR(0.15, hole.width, 0.06);
    EXPECT_NEAR(1, norm(hole.middle), 0.05);
  }
  EXPECT_EQ(ball.triangles.size(), mesh.triangles.size());
  EXPECT_NEAR(volume(ball), volume(mesh), 1e-3);
  EXPECT_EQ(0, c.turned) << "patches face outwards";
}

TEST(MendMesh, KeepsHolesThatAreWide) {
  TriangleMesh mesh = holed_ball({5, 200, 203});
  const MeshCondition narrow = mend_mesh(mesh, 0.01);
  EXPECT_EQ(7, narrow.open);
  EXPECT_EQ(4, narrow.widest_open().edges);
  TriangleMesh open_box = box_mesh(low, high);
  open_box.triangles.resize(10);
  const MeshCondition box = mend_mesh(open_box, 0.5);
  EXPECT_EQ(4, box.open);
  EXPECT_NEAR(4 * 6 / 10.0, box.widest_open().width, 1e-12) << "four areas over the perimeter";
  EXPECT_EQ(2, box.widest_open().middle.x);
}

// Their boundary is that of a hole, and the patch would be the sheet itself.
TEST(MendMesh, KeepsSheetsOpen) {
  TriangleMesh strip{{{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0}, {0, 0.01, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_EQ(4, mend_mesh(strip, 0.1).open);
  EXPECT_EQ(2u, strip.triangles.size());
}

TEST(MendMesh, ClosesACrackAlongASeam) {
  TriangleMesh mesh = box_mesh(low, high);
  mesh.points.push_back({1.5, 2, 3.001});  // in the middle of the edge from 0 to 1, on one side
  mesh.triangles[4] = {0, 8, 4};
  mesh.triangles.push_back({8, 1, 4});
  const MeshCondition c = mend_mesh(mesh, 0.1);
  EXPECT_TRUE(c.closed());
  ASSERT_EQ(1u, c.holes.size());
  EXPECT_LT(c.holes[0].width, 0.002);
  EXPECT_NEAR(6, volume(mesh), 0.01);
}

// Two triangles that share one corner are missing: the boundary is an eight.
TEST(MendMesh, FillsHolesThatMeetAtAPoint) {
  TriangleMesh mesh = ball_mesh(1, 3);
  const int apex = mesh.triangles[0][0];
  std::vector<std::size_t> around;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::find(mesh.triangles[t].begin(), mesh.triangles[t].end(), apex) !=
        mesh.triangles[t].end())
      around.push_back(t);
  ASSERT_EQ(4u, around.size());
  const auto shares = [&](std::size_t s, std::size_t t) {
    int common = 0;
    for (const int a : mesh.triangles[s])
      for (const int b : mesh.triangles[t]) common += a == b;
    return common;
  };
  std::size_t opposite = 1;
  while (shares(around[0], around[opposite]) > 1) ++opposite;
  mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(around[opposite]));
  mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(around[0]));
  const MeshCondition c = mend_mesh(mesh, 0.3);
  EXPECT_TRUE(c.closed());
  EXPECT_EQ(2u, c.holes.size());
}

// The last point lies closer to the two before than the distance at which points are merged; they
// lie farther from each other.
TEST(MendMesh, MergesPointsThatAThirdJoins) {
  TriangleMesh mesh = box_mesh(low, high);
  const double apart = 1e-7 * std::sqrt(14.0);
  const Point along{0.755, 0.57, 0.325}, across{0.6, -0.8, 0.01}, middle{1.5, 3, 4.5};
  mesh.points.push_back(middle + apart * (-0.4 * along + -0.6 * across));
  mesh.points.push_back(middle + apart * (-0.3 * along + 0.6 * across));
  mesh.points.push_back(middle);
  EXPECT_EQ(2, mend_mesh(mesh).merged);
}

// A far point makes all others coincide. The work must not grow with the square of their number:
// it took minutes.
TEST(MendMesh, MergesManyPointsInTime) {
  TriangleMesh mesh = box_mesh(low, high);
  constexpr int count = 300000;
  for (int k = 0; k < count; ++k) {
    const double t = 1e-3 * k;
    mesh.points.push_back(
        {1 + 0.4 * std::sin(t), 2 + 0.4 * std::cos(1.7 * t), 3 + 0.4 * std::sin(2.3 * t)});
  }
  mesh.points.push_back({1e9, 0, 0});
  EXPECT_EQ(count + 7, mend_mesh(mesh).merged);
  TriangleMesh one = box_mesh(low, high);
  one.points.insert(one.points.end(), count, Point{1.5, 2.5, 3.5});
  EXPECT_EQ(count - 1, mend_mesh(one).merged);
}

}  // namespace
}  // namespace freshet::test

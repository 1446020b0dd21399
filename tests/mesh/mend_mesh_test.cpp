// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

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
  EXPECT_EQ(2, c.open_at.x);
  mesh = box_mesh(low, high);
  mesh.points.push_back({1.5, 3, 9});
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_EQ(1, mend_mesh(mesh).crowded);
}

}  // namespace
}  // namespace freshet::test

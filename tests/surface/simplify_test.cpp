// SPDX-License-Identifier: MIT
#include "surface/simplify.h"

#include <gtest/gtest.h>

#include "surface/fluids.h"
#include "surface/mesh_defects.h"

namespace freshet::test {
namespace {

constexpr std::array<double, 3> origin{0, 0, 0};
constexpr float dx = 0.1f;

TEST(MeshDefects, AreEdgesAndPointsThatAreNoManifold) {
  using Triangles = std::vector<GridMesh::Triangle>;
  const Triangles tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(defective_triangles(tetrahedron).empty());
  Triangles open = tetrahedron;
  open.pop_back();
  EXPECT_EQ(defective_triangles(open).size(), 3u);
  Triangles turned = tetrahedron;
  std::swap(turned[0][0], turned[0][1]);
  EXPECT_FALSE(defective_triangles(turned).empty());
  EXPECT_FALSE(defective_triangles({{0, 1, 2}, {0, 2, 1}}).empty());
  Triangles touching = tetrahedron;  // two that share a point
  for (const auto& t : tetrahedron) touching.push_back({t[0] + 3, t[1] + 3, t[2] + 3});
  EXPECT_EQ(defective_triangles(touching).size(), 6u);
  Triangles on_an_edge = tetrahedron;  // two that share an edge
  for (auto t : tetrahedron) {
    for (auto& c : t) c = c < 2 ? c : c + 2;
    on_an_edge.push_back(t);
  }
  EXPECT_FALSE(defective_triangles(on_an_edge).empty());
}

class SimplifiedSurface : public testing::Test {
 protected:
  void SetUp() override {
    if (!simplifies_surfaces()) GTEST_SKIP() << "built without meshoptimizer";
  }
  static SurfaceMesh surface(const Frame& frame, double error,
                             SurfaceVolume volume = SurfaceVolume::particles) {
    return surface_of(frame, double(dx), origin, {.volume = volume, .simplify = error}, 2);
  }
};

TEST_F(SimplifiedSurface, StaysClosedAndManifold) {
  for (const double error : {0.01, 0.05, 0.3, 1.0})
    for (const Frame& frame :
         {cloud(300, 1, 1), cloud(300, 2, 2), cloud(2000, 1.5, 3), ball(0.5, dx, 0.2f),
          slab(1, 0.1f, dx, 0), slab(8, 0.3f, dx, 0.1f), fluid_at({0.01f, 0, 0})}) {
      const SurfaceMesh mesh = surface(frame, error);
      EXPECT_GT(mesh.triangles.size(), 0u);
      EXPECT_EQ(faults_of(mesh), 0) << frame.size() << " particles, error " << error;
      EXPECT_EQ(mesh.normal.size(), mesh.position.size());
      EXPECT_EQ(mesh.velocity.size(), mesh.position.size());
    }
}

TEST_F(SimplifiedSurface, HasFewTrianglesWhereItIsFlat) {
  const Frame frame = slab(8, 0.8f, dx, 0.05f);
  const SurfaceMesh all = surface(frame, 0), few = surface(frame, 0.05);
  EXPECT_LT(double(few.triangles.size()), 0.25 * double(all.triangles.size()));
  EXPECT_NEAR(volume_of(few) / volume_of(all), 1, 0.001);
  EXPECT_NEAR(area_of(few) / area_of(all), 1, 0.01);
  double highest = 0;
  for (const auto& p : few.position)
    if (std::abs(p[0]) < 3.5f && std::abs(p[2]) < 3.5f && p[1] > 0.4f)
      highest = std::max(highest, std::abs(double(p[1]) - 0.8));
  EXPECT_LT(highest, 0.1 * double(dx));
}

/// The number of triangles that face against the normals at their corners.
int folded(const SurfaceMesh& mesh) {
  int count = 0;
  for (const auto& t : mesh.triangles) {
    const auto &a = mesh.position[t[0]], &b = mesh.position[t[1]], &c = mesh.position[t[2]];
    std::array<double, 3> u, v;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = double(b[k] - a[k]);
      v[k] = double(c[k] - a[k]);
    }
    const double area[] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                           u[0] * v[1] - u[1] * v[0]};
    const bool against = std::any_of(t.begin(), t.end(), [&](std::uint32_t corner) {
      const auto& n = mesh.normal[corner];
      return area[0] * double(n[0]) + area[1] * double(n[1]) + area[2] * double(n[2]) < 0;
    });
    count += against;
  }
  return count;
}

TEST_F(SimplifiedSurface, HasNoFolds) {
  const Frame slope = lattice_in(40, dx, 0.1f, [](float x, float y, float z) {
    return std::abs(x) < 3.5f && std::abs(z) < 3.5f && y > -1 && y < 0.3f * x + 0.1f * z + 1;
  });
  for (const double error : {0.01, 0.02, 0.05})
    for (const Frame& frame : {slab(8, 0.8f, dx, 0.1f), slope, ball(1, dx, 0.1f)})
      EXPECT_EQ(folded(surface(frame, error)), 0) << frame.size() << " particles " << error;
}

TEST_F(SimplifiedSurface, OfABallStaysNearIt) {
  const Frame frame = ball(1, dx, 0);
  const SurfaceMesh all = surface(frame, 0, SurfaceVolume::level);
  double triangles = 1e9, low = 2, high = 0;  // the lattice makes steps
  for (const auto& p : all.position) {
    const double r = std::hypot(p[0], p[1], p[2]);
    low = std::min(low, r);
    high = std::max(high, r);
  }
  for (const double error : {0.02, 0.05, 0.1}) {
    const SurfaceMesh mesh = surface(frame, error, SurfaceVolume::level);
    EXPECT_LT(double(mesh.triangles.size()), triangles);
    triangles = double(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
      for (const std::size_t k : {0, 1, 2}) {  // the middles of edges
        const auto &a = mesh.position[t[k]], &b = mesh.position[t[(k + 1) % 3]];
        const double r = std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]) / 2;
        EXPECT_GT(r, low - 3 * error * double(dx));
        EXPECT_LT(r, high + 3 * error * double(dx));
      }
    EXPECT_NEAR(volume_of(mesh) / volume_of(all), 1, 0.15 * error);
  }
}

}  // namespace
}  // namespace freshet::test

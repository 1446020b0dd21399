// SPDX-License-Identifier: MIT
#include "surface/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/point_values.h"

namespace freshet::test {
namespace {

using Point = GridMesh::Point;

/// A ball of points 2 cells apart, with ripples.
GridMesh rippled_ball(double radius, const Threads& threads) {
  std::vector<Point> all;
  for (double z = -radius; z <= radius; z += 2)
    for (double y = -radius; y <= radius; y += 2)
      for (double x = -radius; x <= radius; x += 2)
        if (x * x + y * y + z * z < radius * radius) all.push_back({x, y, z});
  const ParticleBins bins(all, 4);
  return marching_cubes(DensityField(bins, kernels_of(bins, 4, {}, {}, threads), threads), 0.6f,
                        threads);
}

double volume(const GridMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6;
  return sum;
}

/// The mean square deviation of the points' distances from the centre [cells].
double roughness(const GridMesh& mesh) {
  double mean = 0, square = 0;
  for (const Point& p : mesh.points) mean += norm(p) / double(mesh.points.size());
  for (const Point& p : mesh.points) square += std::pow(norm(p) - mean, 2);
  return std::sqrt(square / double(mesh.points.size()));
}

TEST(Smoothing, RemovesRipplesAndKeepsTheVolume) {
  const Threads threads(2);
  const GridMesh rough = rippled_ball(15, threads);
  GridMesh mesh = rough;
  smooth(mesh, {std::vector<float>(mesh.points.size(), 1), {mesh.points.size(), {0, 0, 0}}, 10},
         threads);
  EXPECT_LT(roughness(mesh), 0.8 * roughness(rough));
  EXPECT_NEAR(volume(mesh) / volume(rough), 1, 1e-3);
}

TEST(Smoothing, MovesPointsWithoutWeightAlongTheSurfaceOnly) {
  const Threads threads(1);
  GridMesh mesh = rippled_ball(15, threads);
  const std::vector<Point> before = mesh.points;
  std::vector<Vec<3, float>> normals;
  for (const Point& p : before) {
    const Point n = p / norm(p);
    normals.push_back({float(n.x), float(n.y), float(n.z)});
  }
  smooth(mesh, {std::vector<float>(before.size(), 0), normals, 1}, threads);
  double along = 0, across = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Point step = mesh.points[k] - before[k], n = before[k] / norm(before[k]);
    across = std::max(across, std::abs(dot(step, n)));
    along = std::max(along, norm(step));
  }
  EXPECT_GT(along, 0.1);
  EXPECT_LT(across, 0.02);  // what gives the volume back
}

TEST(Smoothing, KeepsTheVolumeOfEachPart) {
  const Threads threads(1);
  const GridMesh small = rippled_ball(4, threads);
  GridMesh both = rippled_ball(15, threads);
  const auto points = std::uint32_t(both.points.size());
  for (const Point& p : small.points) both.points.push_back(p + Point{60, 0, 0});
  for (const auto& t : small.triangles)
    both.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
  smooth(both, {std::vector<float>(both.points.size(), 1), {both.points.size(), {0, 0, 0}}, 10},
         threads);
  GridMesh part = small;
  for (std::size_t k = 0; k < small.points.size(); ++k)
    part.points[k] = both.points[points + k] - Point{60, 0, 0};
  EXPECT_NEAR(volume(part) / volume(small), 1, 0.03);
}

TEST(Smoothing, KeepsTheRoughShapeOfAPartThatItWouldSpoil) {
  const Threads threads(1);
  const GridMesh rough = rippled_ball(4, threads);
  GridMesh mesh = rough;
  smooth(mesh, {std::vector<float>(mesh.points.size(), 1), {mesh.points.size(), {0, 0, 0}}, 100},
         threads);
  EXPECT_NEAR(volume(mesh) / volume(rough), 1, 1e-12);
}

}  // namespace
}  // namespace freshet::test

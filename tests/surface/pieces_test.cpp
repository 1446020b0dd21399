// SPDX-License-Identifier: MIT
#include "surface/pieces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace freshet::test {
namespace {

constexpr float support = 4, level = 0.6f;  // particles are 2 cells apart

/// Particles at lattice sites, and the mesh around them.
struct Liquid {
  explicit Liquid(const std::vector<Vec<3, int>>& sites) : bins(positions_of(sites), support) {}
  static std::vector<ParticleBins::Point> positions_of(const std::vector<Vec<3, int>>& sites) {
    std::vector<ParticleBins::Point> all;
    for (const auto& s : sites) all.push_back({2.0 * s.x + 0.3, 2.0 * s.y + 0.4, 2.0 * s.z + 0.6});
    return all;
  }
  Pieces pieces() const { return pieces_of(mesh, field, level, bins, threads); }
  std::vector<int> sizes() const {
    std::vector<int> all = pieces().particles;
    std::sort(all.begin(), all.end());
    return all;
  }
  Threads threads{2};
  ParticleBins bins;
  DensityField field{bins, kernels_of(bins, support, {}, {}, threads), threads};
  GridMesh mesh = marching_cubes(field, level, threads);
};

std::vector<Vec<3, int>> cube(int low, int high, int hollow = 0) {
  std::vector<Vec<3, int>> sites;
  for (int z = low; z < high; ++z)
    for (int y = low; y < high; ++y)
      for (int x = low; x < high; ++x) {
        const auto near = [&](int k) { return k - low >= hollow && high - 1 - k >= hollow; };
        if (hollow > 0 && near(x) && near(y) && near(z)) continue;
        sites.push_back({x, y, z});
      }
  return sites;
}

TEST(SurfacePieces, CountTheirParticles) {
  auto sites = cube(-5, 5);
  sites.push_back({9, 0, 0});
  sites.push_back({-20, 3, 7});
  sites.push_back({-20, 4, 7});
  EXPECT_EQ(Liquid(sites).sizes(), (std::vector<int>{1, 2, 1000}));
  EXPECT_TRUE(Liquid({}).sizes().empty());
}

TEST(SurfacePieces, AreOneWithTheirCavities) {
  const Liquid shell(cube(-6, 6, 3));
  EXPECT_EQ(shell.sizes(), (std::vector<int>{12 * 12 * 12 - 6 * 6 * 6}));
  auto filled = cube(-6, 6, 3);
  filled.push_back({0, 0, 0});  // a droplet in the cavity
  EXPECT_EQ(Liquid(filled).sizes(), (std::vector<int>{1, 12 * 12 * 12 - 6 * 6 * 6}));
}

TEST(SurfacePieces, GetTheVolumeOfTheirParticlesByShortSteps) {
  const auto volume = [](const GridMesh& mesh) {
    double sum = 0;
    for (const auto& t : mesh.triangles)
      sum += dot(mesh.points[t[0]], cross(mesh.points[t[1]], mesh.points[t[2]])) / 6;
    return sum;
  };
  Liquid box(cube(-3, 3));
  const Pieces pieces = box.pieces();  // of the points on the edges of the grid
  fit_volumes(box.mesh, pieces, 8, 1);
  EXPECT_NEAR(volume(box.mesh), 216 * 8, 1);
  const double before = volume(box.mesh), area = 6 * 12 * 12;
  fit_volumes(box.mesh, pieces, 16, 0.1);
  EXPECT_GT(volume(box.mesh), before);
  EXPECT_NEAR(volume(box.mesh), before + 0.1 * area, 0.15 * 0.1 * area);
}

}  // namespace
}  // namespace freshet::test

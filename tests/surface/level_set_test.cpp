// SPDX-License-Identifier: MIT
#include "surface/level_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/fluid_grids.h"
#include "surface/fluids.h"

namespace freshet::test {
namespace {

/// The value at a point of the grid; ±band where the level set has no block.
float value_at(const LevelSet& set, Place p) {
  const Place block{floor_div(p.x, block_cells), floor_div(p.y, block_cells),
                    floor_div(p.z, block_cells)};
  const Place in = p - block_cells * block;
  const auto is_here = [&](Place b) { return key_of(b) == key_of(block); };
  for (std::size_t k = 0; k < set.blocks.size(); ++k)
    if (is_here(set.blocks[k])) return set.values[k][std::size_t(point_index(in.x, in.y, in.z))];
  for (const Place& b : set.inside)
    if (is_here(b)) return -LevelSet::band;
  return LevelSet::band;
}

/// The value where a level set of exact distances has `distance`.
float clamped(double distance) {
  return float(std::clamp(distance, double(-LevelSet::band), double(LevelSet::band)));
}

/// An octahedron with these coordinates of its corners along the axes, and its faces outwards.
GridMesh octahedron(double size, GridMesh::Point center) {
  GridMesh mesh;
  for (const GridMesh::Point& p : {GridMesh::Point{size, 0, 0},
                                   {-size, 0, 0},
                                   {0, size, 0},
                                   {0, -size, 0},
                                   {0, 0, size},
                                   {0, 0, -size}})
    mesh.points.push_back(center + p);
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

/// Near its faces, |x| + |y| + |z| - size = sqrt(3) times the distance.
TEST(LevelSet, HasTheDistancesFromAnOctahedron) {
  constexpr int size = 14;
  const LevelSet set = level_set_of(octahedron(size, {0, 0, 0}), Threads(2));
  for (int x = -16; x <= 16; ++x)
    for (int y = -16; y <= 16; ++y)
      for (int z = -16; z <= 16; ++z) {
        const int sum = std::abs(x) + std::abs(y) + std::abs(z);
        const float value = value_at(set, {x, y, z});
        if (sum == size) {
          EXPECT_NEAR(value, 0, 1e-5);
        } else {
          ASSERT_EQ(value < 0, sum < size) << x << " " << y << " " << z;
        }
        if (sum < size) {  // inside, a face is the nearest
          ASSERT_NEAR(value, clamped((sum - size) / std::sqrt(3.0)), 1e-5);
        }
      }
  EXPECT_NEAR(value_at(set, {16, 0, 0}), 2, 1e-6) << "from a corner";
  EXPECT_NEAR(value_at(set, {9, 9, 0}), std::sqrt(8.0), 1e-5) << "from an edge";
}

TEST(LevelSet, KnowsWhatIsDeepInside) {
  const LevelSet set = level_set_of(octahedron(60, {100.3, 7, -40.5}), Threads(1));
  EXPECT_FALSE(set.inside.empty());
  EXPECT_EQ(value_at(set, {100, 7, -40}), -LevelSet::band);
  EXPECT_EQ(value_at(set, {100, 7, 40}), LevelSet::band);
  for (const Place& b : set.inside) {
    const Place p = block_cells * b;  // deep blocks have no point near the faces
    EXPECT_LT(std::abs(p.x - 100.3) + std::abs(p.y - 7) + std::abs(p.z + 40.5), 60 - 3);
  }
}

TEST(LevelSet, OfNothingIsEmpty) {
  const LevelSet set = level_set_of({}, Threads(1));
  EXPECT_TRUE(set.blocks.empty() && set.inside.empty());
}

TEST(FluidGrids, OfABallHaveItsDistancesDensityAndVelocity) {
  constexpr float radius = 0.1f, spacing = 0.01f;
  Frame frame = ball(radius, spacing, 0);
  for (std::size_t i = 0; i < frame.size(); ++i) frame.v[3 * i + 1] = 2;
  const std::array<double, 3> origin{-0.5, -0.4, -0.3};
  const FluidGrids one = grids_of(frame, spacing, origin, {}, 1);
  const FluidGrids two = grids_of(frame, spacing, origin, {}, 2);
  EXPECT_EQ(one.distance.values, two.distance.values);
  EXPECT_EQ(one.velocity, two.velocity);
  double most = 0, sum = 0;  // of errors; those of the surface of a lattice, which has steps
  constexpr int points = 2000;
  for (int k = 0; k < points; ++k) {
    const Place p{60 + k % 80, 40 + k / 80 * 3, 60};
    const double x = origin[0] + one.cell * p.x, y = origin[1] + one.cell * p.y;
    const double distance = std::sqrt(x * x + y * y) - double(radius);
    const double error =
        one.cell * std::abs(double(value_at(one.distance, p) - clamped(distance / one.cell)));
    most = std::max(most, error);
    sum += error;
  }
  EXPECT_LT(sum / points, 0.05 * double(spacing));
  EXPECT_LT(most, 0.2 * double(spacing));
  ASSERT_EQ(one.blocks.size(), one.density.size());
  for (std::size_t b = 0; b < one.blocks.size(); ++b)
    for (std::size_t k = 0; k < block_points; ++k) {
      ASSERT_EQ(one.velocity[b][0][k], 0);
      ASSERT_NEAR(one.velocity[b][1][k], one.density[b][k] > 0 ? 2 : 0, 1e-5);
    }
}

}  // namespace
}  // namespace freshet::test

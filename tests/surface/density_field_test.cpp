// SPDX-License-Identifier: MIT
#include "surface/density_field.h"

#include <gtest/gtest.h>

#include <random>

#include "surface/spline.h"

namespace freshet::test {
namespace {

using Positions = std::vector<ParticleBins::Point>;

/// Particles at random places around 0 [cells].
Positions scattered(int count, double side) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-side / 2, side / 2);
  Positions all;
  for (int k = 0; k < count; ++k) all.push_back({place(random), place(random), place(random)});
  return all;
}

double distance(ParticleBins::Point a, ParticleBins::Point b) { return norm(a - b); }

double spline(double r, double support) {
  const double q = r / support, far = std::max(1 - q, 0.0), near = std::max(0.5 - q, 0.0);
  return 2 * (far * far * far - 4 * near * near * near);
}

TEST(Lattice, KeysHoldPlacesInOrder) {
  const std::vector<Place> ordered{{-5, -7, -9}, {farthest_place, -7, -9}, {-5, 2, -9}, {0, 0, 0},
                                   {1, 0, 0},    {-farthest_place, 1, 0}};
  for (std::size_t k = 0; k < ordered.size(); ++k) {
    const Place p = ordered[k], q = place_of(key_of(p));
    EXPECT_TRUE(p.x == q.x && p.y == q.y && p.z == q.z);
    if (k > 0) {
      EXPECT_LT(key_of(ordered[k - 1]), key_of(p));
    }
  }
  EXPECT_EQ(floor_div(-1, 8), -1);
  EXPECT_EQ(floor_div(-8, 8), -1);
  EXPECT_EQ(floor_div(-9, 8), -2);
  EXPECT_EQ(floor_div(7, 8), 0);
}

TEST(SurfaceSpline, SlopeIsItsDerivative) {
  const Spline w(4);
  EXPECT_EQ(w(0), 1);
  EXPECT_EQ(w(16), 0);
  for (const float r : {0.01f, 0.5f, 1.9f, 2.1f, 3.0f, 3.9f}) {
    const double step = 1e-3, rise = spline(double(r) + step, 4) - spline(double(r) - step, 4);
    EXPECT_NEAR(w(r * r), spline(double(r), 4), 1e-6);
    EXPECT_NEAR(double(w.slope(r * r) * r), rise / (2 * step), 1e-4) << r;
  }
}

TEST(ParticleBins, CollectTheParticlesNearABox) {
  for (const float support : {2.5f, 4.0f, 9.0f}) {
    const Positions all = scattered(500, 40);
    const ParticleBins bins(all, support);
    const Place low{-1, 0, 1};
    Nearby nearby;
    bins.collect(low, 2, nearby);
    std::set<int> found, expected;
    for (std::size_t j = 0; j < nearby.size(); ++j) {
      const int index = bins.frame_index(nearby.particle[j]);
      found.insert(index);
      EXPECT_NEAR(nearby.x[j], all[std::size_t(index)].x + 4, 1e-4);
      EXPECT_NEAR(nearby.z[j], all[std::size_t(index)].z - 4, 1e-4);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const ParticleBins::Point x = all[i];
      const ParticleBins::Point nearest{std::clamp(x.x, -4.0, 4.0), std::clamp(x.y, 0.0, 8.0),
                                        std::clamp(x.z, 4.0, 12.0)};
      if (distance(x, nearest) < double(support)) expected.insert(int(i));
    }
    EXPECT_EQ(found, expected) << support;
    EXPECT_EQ(found.size(), nearby.size());
  }
}

TEST(DensityField, IsTheSumOverParticlesAndZeroElsewhere) {
  const Positions all = scattered(200, 30);
  const float support = 5;
  const Threads threads(2);
  const ParticleBins bins(all, support);
  const Kernels kernels = kernels_of(bins, support, {}, {}, threads);
  std::vector<double> volume(all.size());
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const auto index = std::size_t(bins.frame_index(int(k)));
    double sum = 0;
    for (const auto& x : all) sum += spline(distance(x, all[index]), double(support));
    volume[index] = 1 / sum;
    EXPECT_NEAR(double(kernels.volume[k]), volume[index], 1e-5);
  }
  const DensityField field(bins, kernels, threads);
  for (int z = -24; z <= 24; z += 3)
    for (int y = -24; y <= 24; y += 3)
      for (int x = -24; x <= 24; x += 3) {
        double sum = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
          sum += volume[i] *
                 spline(distance(all[i], {double(x), double(y), double(z)}), double(support));
        const Place block{floor_div(x, 8), floor_div(y, 8), floor_div(z, 8)};
        const int b = field.find(block);
        const auto point =
            std::size_t(point_index(x - 8 * block.x, y - 8 * block.y, z - 8 * block.z));
        EXPECT_NEAR(b < 0 ? 0 : double(field.values(b)[point]), sum, 1e-5);
      }
}

}  // namespace
}  // namespace freshet::test

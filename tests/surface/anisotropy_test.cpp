// SPDX-License-Identifier: MIT
#include "surface/anisotropy.h"

#include <gtest/gtest.h>

#include <random>

namespace freshet::test {
namespace {

TEST(Eigen3, GivesValuesAndVectors) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1, 1);
  for (int k = 0; k < 200; ++k) {
    Symmetric3 m{any(random), any(random), any(random), any(random), any(random), any(random)};
    if (k % 4 == 1) m.xy = m.xz = 0;            // an axis of space
    if (k % 4 == 2) m.xx = m.yy = m.zz = m.xy;  // equal values on the diagonal
    if (k == 3) m = {0, 0, 0, 0, 0, 0};
    const Eigen3 eigen(m);
    EXPECT_NEAR(eigen.value[0] + eigen.value[1] + eigen.value[2], double(m.xx + m.yy + m.zz), 1e-6);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<3, double> v = eigen.vector[i];
      const Vec<3, float> turned = m * Vec<3, float>{float(v.x), float(v.y), float(v.z)};
      EXPECT_NEAR(double(turned.x), eigen.value[i] * v.x, 1e-6);
      EXPECT_NEAR(double(turned.y), eigen.value[i] * v.y, 1e-6);
      EXPECT_NEAR(double(turned.z), eigen.value[i] * v.z, 1e-6);
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(dot(v, eigen.vector[j]), double(i == j), 1e-9);
    }
  }
}

/// Particles two cells apart in a box of sites.
struct Box {
  Box(int nx, int ny, int nz) {
    for (int z = 0; z < nz; ++z)
      for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) positions.push_back({2.0 * x, 2.0 * y, 2.0 * z});
  }
  Anisotropy anisotropy() const {
    return anisotropy_of(ParticleBins(positions, shape_reach * 4), 4, 2, Threads(2));
  }
  std::vector<ParticleBins::Point> positions;
};

TEST(Anisotropy, StretchesKernelsAlongASurface) {
  const int n = 13;
  const Anisotropy a = Box(n, n, n).anisotropy();
  const auto at = [&](int x, int y, int z) { return std::size_t((z * n + y) * n + x); };
  EXPECT_EQ(a.shape[at(6, 6, 6)].reach, 1);  // deep in the liquid
  const KernelShape& top = a.shape[at(6, n - 1, 6)];
  EXPECT_GT(top.reach, 1.3f);
  EXPECT_NEAR(top.shrink.yy, 1, 1e-4);  // as it was across the surface
  EXPECT_NEAR(top.shrink.xx, 1 / top.reach, 1e-4);
  EXPECT_NEAR(top.shrink.zz, 1 / top.reach, 1e-4);
  for (const float other : {top.shrink.xy, top.shrink.xz, top.shrink.yz})
    EXPECT_NEAR(other, 0, 1e-5);
  for (const KernelShape& shape : a.shape) EXPECT_LE(shape.reach, longest_stretch);
}

TEST(Anisotropy, KeepsDropletsRound) {
  for (const Box& drop : {Box(1, 1, 1), Box(2, 2, 2), Box(6, 1, 1)}) {
    const Anisotropy a = drop.anisotropy();
    for (const KernelShape& shape : a.shape) EXPECT_EQ(shape.reach, 1);
    for (const auto& shift : a.shift) EXPECT_EQ(norm2(shift), 0);
  }
}

TEST(Anisotropy, MovesAParticleIntoItsLayer) {
  const int n = 13;
  Box box(n, n, n);
  const auto raised = std::size_t((6 * n + n - 1) * n + 6), deep = std::size_t((6 * n + 6) * n + 6);
  box.positions[raised].y += 0.5;
  const Anisotropy a = box.anisotropy();
  EXPECT_NEAR(a.shift[raised].y, -0.35, 0.1);
  EXPECT_EQ(norm2(a.shift[deep]), 0);
  const auto other = std::size_t((3 * n + n - 1) * n + 6);  // in the layer, a few sites away
  EXPECT_NEAR(a.shift[other].y, 0, 0.05);
}

}  // namespace
}  // namespace freshet::test

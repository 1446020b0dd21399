// SPDX-License-Identifier: MIT
#include "backend/kd_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "backend/cloud.h"

namespace freshet {
namespace {

template <int D> void expect_brute_forces_neighbors() {
  const Real h = Real(0.3f);
  for (const double offset : {-1.0, 0.0, 1000.37}) {
    const Cloud<D> cloud(400, 2, offset);
    const KdTree<D> tree(cloud.particles);
    for (int i = 0; i < 400; ++i) {
      std::vector<int> found;
      tree.find(cloud.x[i], h * h, found);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(cloud.near(i, h), found) << i;
    }
  }
}

TEST(KdTree, FindsTheNeighborsOfBruteForceIn2D) { expect_brute_forces_neighbors<2>(); }
TEST(KdTree, FindsTheNeighborsOfBruteForceIn3D) { expect_brute_forces_neighbors<3>(); }

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "backend/reference/neighbor_lists.h"

#include <gtest/gtest.h>

#include "backend/cloud.h"

namespace freshet {
namespace {

template <int D>
std::vector<std::vector<int>> rows(Search search, NeighborOrder order, Real h,
                                   const Particles<D>& p) {
  NeighborLists<D> lists;
  lists.build(search, order, h, p, p);
  std::vector<std::vector<int>> all;
  for (int i = 0; i < p.n; ++i) all.emplace_back(lists[i].begin(), lists[i].end());
  return all;
}

template <class T> class NeighborListsOf : public ::testing::Test {};
template <int d> struct Dimension { static constexpr int D = d; };
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(NeighborListsOf, Dimensions);

// The grids contain the origin, touch it, or are far from it.
TYPED_TEST(NeighborListsOf, EqualThoseOfBruteForce) {
  constexpr int D = TypeParam::D;
  const Real h = Real(0.3f);
  for (const double offset : {-1.0, 0.0, 1000.37}) {
    const Cloud<D> cloud(400, 2, offset);
    const auto found = rows<D>(Search::grid, NeighborOrder::id, h, cloud.particles);
    for (int i = 0; i < 400; ++i) ASSERT_EQ(cloud.near(i, h), found[i]) << i;
  }
}

TYPED_TEST(NeighborListsOf, HaveTheSameOrderInBothSearches) {
  constexpr int D = TypeParam::D;
  const Cloud<D> cloud(500, 2, -0.7);
  for (const NeighborOrder order : {NeighborOrder::id, NeighborOrder::cell})
    EXPECT_EQ(rows<D>(Search::grid, order, Real(0.3f), cloud.particles),
              rows<D>(Search::all_pairs, order, Real(0.3f), cloud.particles));
}

TYPED_TEST(NeighborListsOf, AreRightForFarAndNanParticles) {
  constexpr int D = TypeParam::D;
  Cloud<D> cloud(100, 2, 0);
  cloud.x[5].x = Real(2e9f);
  cloud.x[6].x = Real(-3e30f);
  cloud.x[7].x = std::numeric_limits<Real>::quiet_NaN();
  cloud.x[8] = cloud.x[9];  // coincident particles
  const auto found = rows<D>(Search::grid, NeighborOrder::id, Real(0.3f), cloud.particles);
  EXPECT_EQ(std::vector<int>{5}, found[5]);
  EXPECT_EQ(std::vector<int>{6}, found[6]);
  EXPECT_EQ(std::vector<int>{}, found[7]);
  EXPECT_EQ(found[8], found[9]);
  EXPECT_EQ(found, rows<D>(Search::all_pairs, NeighborOrder::id, Real(0.3f), cloud.particles));
}

TYPED_TEST(NeighborListsOf, OfASingleParticleHoldItself) {
  constexpr int D = TypeParam::D;
  const Cloud<D> cloud(1, 2, 0);
  EXPECT_EQ((std::vector<std::vector<int>>{{0}}),
            rows<D>(Search::grid, NeighborOrder::cell, Real(0.3f), cloud.particles));
}

}  // namespace
}  // namespace freshet

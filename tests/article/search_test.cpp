// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/article_scene.h"
#include "backend/reference/neighbor_lists.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

/// The article's lattice and jitter with side x side particles.
Sample block(int side) {
  const std::string count = "[" + std::to_string(side) + ", " + std::to_string(side) + "]";
  return sample(article_scene({{"fluid.count", count}}));
}
Particles<2> particles(Sample& sample) {
  Particles<2> p;
  p.n = int(sample.x.size() / 2);
  p.x.data = reinterpret_cast<Vec<2>*>(sample.x.data());
  return p;
}

TEST(ArticleSearch, GridFindsTheNeighborsOfAllPairs) {
  Sample start = block(40);
  const Particles<2> p = particles(start);
  for (const Real h : {Real(0.2), Real(0.3), Real(0.5)})
    for (const NeighborOrder order : {NeighborOrder::id, NeighborOrder::cell}) {
      NeighborLists<2> grid, all_pairs;
      grid.build(Search::grid, order, h, p, p);
      all_pairs.build(Search::all_pairs, order, h, p, p);
      for (int i = 0; i < p.n; ++i)
        ASSERT_TRUE(
            std::equal(grid[i].begin(), grid[i].end(), all_pairs[i].begin(), all_pairs[i].end()))
            << i;
    }
}

TEST(ArticleSearch, GridGivesTheBitsOfAllPairs) {
  const Scene grid = article_scene(), all_pairs = article_scene({{"solver.search", "all_pairs"}});
  EXPECT_EQ(after_steps(all_pairs, 50).state_sha256(), after_steps(grid, 50).state_sha256());
}

/// Number of particles that a grid search compares a particle with: maximum and mean.
struct Candidates {
  std::size_t most = 0;
  double mean = 0;
};
Candidates candidates(int side, double h) {
  Sample start = block(side);
  const Particles<2> p = particles(start);
  CellGrid<2> grid;
  const CellGrid<2> no_copies;
  grid.build(Real(h), p.x, p.n);
  Candidates c;
  grid.for_each(grid, no_copies, [&](const auto&, const auto& near) {
    c.most = std::max(c.most, near.size());
    c.mean += double(near.size()) / p.n;
  });
  return c;
}

TEST(ArticleSearch, ComparisonsPerParticleDoNotGrowWithTheirNumber) {
  // Nine cells of side 0.2 are a square of side 0.6: 16 lattice points of spacing 0.15, at most 5 x
  // 5.
  for (const int side : {25, 79, 250}) {  // 625, 6241, 62500 particles
    const Candidates c = candidates(side, 0.2);
    EXPECT_LE(c.most, 25u) << side;
    EXPECT_NEAR(16, c.mean, 1.5) << side;
  }
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/article_scene.h"
#include "boundary/box_walls.h"
#include "freshet/derived.h"
#include "render/dots.h"

namespace freshet {
namespace {

class ArticleScene : public ::testing::Test {
 protected:
  void SetUp() override {  // in double, the random offsets differ
    if (sizeof(Real) != sizeof(float)) GTEST_SKIP() << "the article computes in float";
  }
};

double mean_density(const std::vector<Override>& overrides) {
  const Scene scene = article_scene(overrides);
  return after_steps(scene, scene.steps()).statistics().density_mean;
}

/// The article's run, computed once for all tests.
const Simulation& finished() {
  static const Simulation simulation = after_steps(article_scene(), 2000);
  return simulation;
}

TEST_F(ArticleScene, PutsAQuarterOfItsParticlesOntoTheLid) {
  const Scene scene = article_scene();
  EXPECT_NEAR(3.9, scene.fluid[0].from[1] + 24 * scene.particles.spacing, 1e-12);
  EXPECT_EQ(154, derive(scene).outside);

  const Simulation simulation = after_steps(scene, 1);
  const ParticleView fluid = simulation.fluid();
  int on_lid = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) on_lid += fluid.x[2 * i + 1] == 3;
  EXPECT_EQ(154, on_lid);
  // Seven rows of the lattice now share one height and are separated by the jitter only: the second
  // step computes more than six times the rest density there.
  EXPECT_LT(simulation.statistics().density_max, 0.9);
  EXPECT_NEAR(5.28, after_steps(scene, 2).statistics().density_max, 0.02);
}

TEST_F(ArticleScene, HoldsMoreFluidThanItsBox) {
  const Scene scene = article_scene();
  const Derived d = derive(scene);
  EXPECT_NEAR(15, d.particles * d.mass / d.rest_density, 1e-9);
  EXPECT_NEAR(12, scene.domain.max[0] * scene.domain.max[1], 1e-9);
}

// A fluid of 15 m² in a box of 12 m² has a density of 1. The mean is 3.6 for two other reasons. The
// fluid is too soft: a block that fits is compressed too, and ten times the stiffness supports the
// whole block. Walls that only collide let a third of all particles stack up on them.
TEST_F(ArticleScene, IsDenseBecauseItIsSoft) {
  const Derived d = derive(article_scene());
  EXPECT_NEAR(1, d.particles * d.mass / 12, 1e-9);
  EXPECT_NEAR(3.62, finished().statistics().density_mean, 0.01);
  EXPECT_GT(mean_density({{"fluid.count", "[24, 17]"}}), 3.2);
  EXPECT_LT(mean_density({{"solver.stiffness", "500"}}), 1);
}
TEST_F(ArticleScene, StacksAThirdOfItsParticlesOnTheWalls) {
  const ParticleView fluid = finished().fluid();
  int stacked = 0;
  double dense = 0, inside = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const Real x = fluid.x[2 * i], y = fluid.x[2 * i + 1], near = Real(0.01);
    const bool at_wall = x < near || x > 4 - near || y < near;
    stacked += at_wall;
    (at_wall ? dense : inside) += double(fluid.density[i]);
  }
  EXPECT_EQ(209, stacked);
  EXPECT_NEAR(4.92, dense / stacked, 0.01);
  EXPECT_NEAR(2.92, inside / (600 - stacked), 0.01);
}

TEST_F(ArticleScene, BottomThirdCountsPixelsNotParticles) {
  const Frame fluid = finished().frame();
  const Image image = draw_dots(finished().scene(), fluid);
  int pixels = 0;
  for (int y = 400; y < 600; ++y)
    for (int x = 0; x < 800; ++x)
      pixels += !(image.pixels[std::size_t(y * 800 + x)] == Color{8, 10, 28});
  EXPECT_EQ(41727, pixels);
  EXPECT_EQ(41727, picture_statistics(image).bottom_third);

  int particles = 0;
  for (std::size_t i = 0; i < fluid.size(); ++i) particles += fluid.x[2 * i + 1] < 1;
  EXPECT_EQ(600u, fluid.size());
  EXPECT_EQ(598, particles);

  // Without particles, only the lines of the picture's border are counted.
  const Image empty = draw_dots(finished().scene(), Frame{});
  EXPECT_EQ(1198, picture_statistics(empty).bottom_third);
}

// A restitution of 0.5 halves the speed and leaves a quarter of the energy; sqrt(0.5) leaves half.
TEST(ArticleWalls, LoseThreeQuartersOfTheNormalEnergy) {
  const auto share_left = [](Real restitution) {
    const BoxWalls<2> walls{{0, 0}, {4, 3}, restitution, 0b1111, true};
    Vec<2> x{2, Real(-0.01)}, v{1, -4};
    walls(x, v);
    EXPECT_EQ(0, x.y);
    EXPECT_EQ(1, v.x);  // no loss along the wall
    EXPECT_GT(v.y, 0);
    return v.y * v.y / 16;
  };
  EXPECT_EQ(Real(0.25), share_left(Real(0.5)));
  EXPECT_NEAR(0.5, share_left(std::sqrt(Real(0.5))), 1e-6);
}

}  // namespace
}  // namespace freshet

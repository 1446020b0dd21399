// SPDX-License-Identifier: MIT
// Pictures, state and statistics of the article's scene, with both neighbour searches.
#include <gtest/gtest.h>

#include "core/sha256.h"
#include "freshet/simulation.h"
#include "render/dots.h"

namespace freshet {
namespace {

#ifndef FRESHET_DOUBLE

std::string picture_sha256(const Simulation& sim) {
  const Image image = draw_dots(sim.scene(), sim.frame());
  Sha256 sha;
  sha.add(image.pixels.data(), 3 * image.pixels.size());
  return sha.hex();
}

class ArticleGolden : public ::testing::TestWithParam<const char*> {};

TEST_P(ArticleGolden, FramesAndStatisticsAreThoseOfTheArticle) {
  Simulation sim(load_scene(SOURCE_DIR "/scenes/article.toml", {{"solver.search", GetParam()}}));
  std::vector<std::string> frames;
  while (sim.steps_done() < 2000) {
    sim.step();
    const auto step = sim.steps_done() - 1;
    if (step % 500 == 0 || step == 1999) frames.push_back(picture_sha256(sim));
  }
  const std::vector<std::string> article{
      "d1e101eb60c2f6d7d090b767e1a79648661e61da02dabd39294e5638920d02d2",
      "c35ecdffe027abe16925f49980cae40f704791fa07236a25f85015f61ab44557",
      "c6732ff033f3bb7a54fac25ff6de49f1eeb850b2a8e6c69eff3e13c96ee02795",
      "ba4c7d544046f93bbc07c60965bf4092697138544f4754b31a99e2ba29e67aaf",
      "3758a24fbff9fbc8eeafc4ffa23dbb22f8c656d39b549e945d690c54cfdf23b5"};
  EXPECT_EQ(article, frames);
  EXPECT_EQ("209739a4641c59b9a1dc195b15a58aee12ca9bf8bd28091793e8a501958e80de", sim.state_sha256());

  const Statistics s = sim.statistics();
  EXPECT_EQ(600, s.particles);
  EXPECT_EQ(0, s.out_of_bounds);
  EXPECT_NEAR(3.61630, s.density_mean, 5e-6);
  EXPECT_NEAR(0.80973, s.density_min, 5e-6);
  EXPECT_NEAR(6.19199, s.density_max, 5e-6);
  EXPECT_NEAR(0.303263, s.speed_mean, 5e-7);
  EXPECT_NEAR(1.311986, s.speed_max, 5e-7);
  EXPECT_NEAR(0.281334, s.height_mean, 5e-7);
  const PictureStatistics p = picture_statistics(draw_dots(sim.scene(), sim.frame()));
  EXPECT_EQ(30844, p.bright);
  EXPECT_EQ(41727, p.bottom_third);
}

INSTANTIATE_TEST_SUITE_P(Search, ArticleGolden, ::testing::Values("grid", "all_pairs"),
                         [](const auto& search) { return std::string(search.param); });

TEST(Golden, MuellersPaperSchemeHasTheRecordedState) {
  Simulation sim(load_scene(SOURCE_DIR "/scenes/article_corrected.toml",
                            {{"particles.spacing", "0.1"}, {"particles.support_radius", "0.2"}}));
  while (sim.steps_done() < 500) sim.step();
  EXPECT_EQ("bd4d217801d4c05977c37d30584b0578797615876c43a874c3017643a53c0272", sim.state_sha256());
}

#endif

}  // namespace
}  // namespace freshet

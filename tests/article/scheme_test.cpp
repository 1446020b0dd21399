// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/article_scene.h"
#include "engine/parameters.h"
#include "sim/plan_of_scene.h"

namespace freshet {
namespace {

// Compares scheme = "article" with the default "paper". Each of the five differences has its
// number.
TEST(ArticleScheme, DiffersFromThePapersInFivePoints) {
  const Scene article_s = article_scene();
  Scene paper_s = article_s;
  paper_s.solver.scheme = Scheme::paper;
  paper_s.solver.speed_limit.reset();
  paper_s.particles.mass.reset();
  paper_s.places.clear();
  const Derived of_article = derive(article_s), of_paper = derive(paper_s);
  const auto article =
      parameters_of(plan_of(article_s, of_article, nullptr, 1), Mueller2003Parameters<2>{});
  const auto paper =
      parameters_of(plan_of(paper_s, of_paper, nullptr, 1), Mueller2003Parameters<2>{});

  EXPECT_EQ(Real(10), article.spiky_factor);  // 1
  EXPECT_EQ(Real(30), paper.spiky_factor);
  EXPECT_EQ(Real(0.02), article.m);  // 2: set by the scene; the density sum is not normalised
  EXPECT_EQ(article.m, article.m_density);
  EXPECT_FLOAT_EQ(0.8f * 0.15f * 0.15f, float(paper.m));
  EXPECT_FLOAT_EQ(float(double(paper.m) / (1 + of_paper.density_error)), float(paper.m_density));
  EXPECT_EQ(Real(20), article.speed_limit);  // 3
  EXPECT_TRUE(std::isinf(paper.speed_limit));
  EXPECT_TRUE(article.confine.box.onto_wall);  // 4
  EXPECT_FALSE(paper.confine.box.onto_wall);
  EXPECT_TRUE(article.article);  // 5
  EXPECT_FALSE(paper.article);
  EXPECT_EQ(Integrator::leapfrog, paper.integrator);

  EXPECT_EQ(article_s.time.step, paper_s.time.step);
  EXPECT_EQ(article.h, paper.h);
  EXPECT_EQ(article.rho0, paper.rho0);
  EXPECT_EQ(article.k, paper.k);
  EXPECT_EQ(article.mu, paper.mu);
  EXPECT_EQ(article.gravity.x, paper.gravity.x);
  EXPECT_EQ(article.gravity.y, paper.gravity.y);
  EXPECT_EQ(article.confine.box.min.x, paper.confine.box.min.x);
  EXPECT_EQ(article.confine.box.min.y, paper.confine.box.min.y);
  EXPECT_EQ(article.confine.box.max.x, paper.confine.box.max.x);
  EXPECT_EQ(article.confine.box.max.y, paper.confine.box.max.y);
  EXPECT_EQ(article.confine.box.sides, paper.confine.box.sides);
  EXPECT_EQ(article.confine.box.restitution, paper.confine.box.restitution);
}

}  // namespace
}  // namespace freshet

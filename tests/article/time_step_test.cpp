// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "article/article_scene.h"
#include "freshet/derived.h"

namespace freshet {
namespace {

struct Course {
  double kinetic = 0;  ///< mean over the second half of the run [J/m]
  double fastest = 0;  ///< maximum over all steps [m/s]
};

Course course(const Scene& scene) {
  Course course;
  Simulation simulation(scene);
  std::int64_t counted = 0;
  while (simulation.steps_done() < scene.steps()) {
    simulation.step();
    const Statistics s = simulation.statistics();
    course.fastest = std::max(course.fastest, s.speed_max);
    if (2 * simulation.steps_done() <= scene.steps()) continue;
    course.kinetic += s.kinetic_energy;
    ++counted;
  }
  course.kinetic /= double(counted);
  return course;
}

/// The article's time-step limit, h/v_max.
double articles_bound(const Scene& scene, const Course& course) {
  return derive(scene).support_radius / course.fastest;
}

// Steps of 15 ms obey the article's limit h/v_max = 0.2/9.8 = 20 ms during the whole run. The fluid
// still does not come to rest: its kinetic energy is 8.6 J/m instead of 1.5 J/m.
TEST(ArticleTimeStep, HeatsTheFluidBelowTheArticlesBound) {
  const Scene fine = article_scene({{"time.end", "4"}});
  const Scene coarse = article_scene({{"time.end", "4"}, {"time.step", "0.015"}});
  const Course calm = course(fine), hot = course(coarse);
  EXPECT_LT(derive(coarse).acoustic_step, coarse.time.step);
  EXPECT_LT(coarse.time.step, articles_bound(coarse, hot));
  EXPECT_GT(hot.kinetic, 3 * calm.kinetic);
}

// The speed limit of 20 m/s keeps h/v_max at 10 ms or more in a stiffer fluid too. But sound is ten
// times faster, and with steps of 5 ms the fluid boils: its kinetic energy is 1905 J/m, while its
// potential energy was 247 J/m at the start.
TEST(ArticleTimeStep, NeedsTheSpeedOfSound) {
  const auto stiff = [](const char* step) {
    return article_scene({{"solver.stiffness", "5000"}, {"time.step", step}, {"time.end", "0.6"}});
  };
  const Scene bounded = stiff("0.0005"), unbounded = stiff("0.005");
  EXPECT_NEAR(0.000566, derive(bounded).acoustic_step, 1e-6);
  EXPECT_STREQ("speed of sound", derive(bounded).step_bound_name());
  const Course good = course(bounded), bad = course(unbounded);
  EXPECT_LT(unbounded.time.step, articles_bound(unbounded, bad));
  const double start = Simulation(bounded).statistics().potential_energy;
  EXPECT_LT(good.kinetic, start);
  EXPECT_GT(bad.kinetic, 5 * start);
}

}  // namespace
}  // namespace freshet

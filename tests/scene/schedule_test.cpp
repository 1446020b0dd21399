// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene/model/schedule.h"

namespace freshet {
namespace {

Scene scene_of(double end, double step) {
  Scene scene;
  scene.time.end = end;
  scene.time.step = step;
  return scene;
}

/// The steps after which frames are written. Expects that their number is the planned one.
std::vector<std::int64_t> frames_of(const Scene& scene) {
  const Schedule schedule(scene);
  std::vector<std::int64_t> frames;
  const double dt = scene.time.step;
  for (std::int64_t k = 0; k < scene.steps(); ++k)
    if (schedule.frame_after({k, double(k) * dt, double(k + 1) * dt, k + 1 == scene.steps()}))
      frames.push_back(k);
  EXPECT_EQ(std::int64_t(frames.size()), schedule.frames());
  return frames;
}

using Steps = std::vector<std::int64_t>;

TEST(Schedule, WritesFramesByTheNumberOfSteps) {
  Scene scene = scene_of(1, 0.1);
  scene.output.frame_every_steps = 4;
  EXPECT_EQ((Steps{0, 4, 8, 9}), frames_of(scene));
  EXPECT_EQ(11u, frames_of(scene_of(101, 1)).size());
  EXPECT_EQ((Steps{0}), frames_of(scene_of(1, 1)));
}

TEST(Schedule, WritesAFrameAfterTheFirstStepThatReachesATime) {
  Scene scene = scene_of(1, 0.1);
  scene.output.frame_every = 0.3;  // 0.3, 0.6 and 0.9 s: the ends of steps 2, 5 and 8
  EXPECT_EQ((Steps{0, 2, 5, 8, 9}), frames_of(scene));
  scene.output.frame_every = 0.25;  // 0.25 s is within step 2, 0.5 s is the end of step 4
  EXPECT_EQ((Steps{0, 2, 4, 7, 9}), frames_of(scene));
  scene.output.frame_every = 0.1;
  EXPECT_EQ(10u, frames_of(scene).size());
  scene.output.frame_every = 5;
  EXPECT_EQ((Steps{0, 9}), frames_of(scene));
}

TEST(Schedule, PlansTheNumberOfFramesForAnyStep) {
  for (const double step : {0.001, 0.0013, 0.017, 0.1, 0.3, 1.0})
    for (const double every : {0.3, 0.31, 0.9, 1.0, 2.0}) {
      Scene scene = scene_of(3, step);
      if (every < step) continue;
      scene.output.frame_every = every;
      frames_of(scene);
    }
}

/// The steps after which data files are written. Expects that their number is the planned one.
Steps data_of(const Scene& scene) {
  const Schedule schedule(scene);
  Steps steps;
  const double dt = scene.time.step;
  for (std::int64_t k = 0; k < scene.steps(); ++k)
    if (schedule.data_after({k, double(k) * dt, double(k + 1) * dt, k + 1 == scene.steps()}))
      steps.push_back(k);
  EXPECT_EQ(std::int64_t(steps.size()), schedule.data_frames());
  return steps;
}

TEST(Schedule, WritesDataWithTheFramesOrByItsOwnKeys) {
  Scene scene = scene_of(1, 0.1);
  scene.output.frame_every_steps = 4;
  EXPECT_EQ((Steps{0, 4, 8, 9}), data_of(scene));
  scene.output.data_every = 0.3;
  EXPECT_EQ((Steps{0, 2, 5, 8, 9}), data_of(scene));
  scene.output.data_every.reset();
  scene.output.data_every_steps = 5;
  EXPECT_EQ((Steps{0, 5, 9}), data_of(scene));
  EXPECT_EQ((Steps{0, 4, 8, 9}), frames_of(scene));
  scene.output.data = {};
  EXPECT_EQ(Steps{}, data_of(scene));
}

// The number of such intervals in a run is beyond any integer.
TEST(Schedule, ObservesAfterEveryStepForAnIntervalOfAlmostNothing) {
  Scene scene = scene_of(1, 0.1);
  scene.output.observables_every = 1e-30;
  const Schedule schedule(scene);
  for (std::int64_t k = 1; k < 9; ++k)
    EXPECT_TRUE(schedule.observe_after({k, 0.1 * double(k), 0.1 * double(k + 1), false})) << k;
}

TEST(Schedule, OfAdaptiveStepsIsInSeconds) {
  Scene scene = scene_of(1, 0);
  scene.time.adaptive = true;
  scene.time.step_max = 0.05;
  EXPECT_EQ(20, scene.steps());
  const Schedule schedule(scene);
  int frames = 0;
  double time = 0;
  for (std::int64_t k = 0; time < 1; ++k) {
    const double after = std::min(1.0, time + (k % 2 == 0 ? 0.013 : 0.05));
    frames += schedule.frame_after({k, time, after, after >= 1});
    time = after;
  }
  EXPECT_EQ(frames, schedule.frames());
  EXPECT_EQ(11, frames);
}

}  // namespace
}  // namespace freshet

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

using Times = std::vector<double>;

/// The times of frames, with that of the end.
Times times_of(const Scene& scene, const Every& every) {
  Times times;
  const double dt = scene.time.step;
  for (std::int64_t k = 0; k < scene.steps(); ++k)
    for (const double t : every.frames_in({k, double(k) * dt, double(k + 1) * dt, false}))
      times.push_back(t);
  const double end = double(scene.steps()) * dt;
  if (times.empty() || times.back() != end) times.push_back(end);
  return times;
}
/// Expects that the number of frames is the planned one.
Times frames_of(const Scene& scene) {
  const Schedule schedule(scene);
  const Times times = times_of(scene, schedule.frame());
  EXPECT_EQ(std::int64_t(times.size()), schedule.frames());
  return times;
}
void expect_times(const Times& expected, const Times& times) {
  ASSERT_EQ(expected.size(), times.size());
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(expected[k], times[k], 1e-12);
}

TEST(Schedule, WritesFramesByTheNumberOfSteps) {
  Scene scene = scene_of(1, 0.1);
  scene.output.frame_every_steps = 4;
  expect_times({0.1, 0.5, 0.9, 1}, frames_of(scene));
  EXPECT_EQ(11u, frames_of(scene_of(101, 1)).size());
  expect_times({1}, frames_of(scene_of(1, 1)));
}

TEST(Schedule, WritesFramesAtExactlyTheirTimes) {
  Scene scene = scene_of(1, 0.1);
  scene.output.frame_every = 0.3;
  expect_times({0, 0.3, 0.6, 0.9, 1}, frames_of(scene));
  scene.output.frame_every = 0.25;  // within a step
  expect_times({0, 0.25, 0.5, 0.75, 1}, frames_of(scene));
  scene.output.frame_every = 0.04;  // two or three in a step
  EXPECT_EQ(26u, frames_of(scene).size());
  scene.output.frame_every = 5;
  expect_times({0, 1}, frames_of(scene));
}

TEST(Schedule, PlansTheNumberOfFramesForAnyStep) {
  for (const double step : {0.001, 0.0013, 0.017, 0.1, 0.3, 1.0})
    for (const double every : {0.3, 0.31, 0.9, 1.0, 2.0}) {
      Scene scene = scene_of(3, step);
      scene.output.frame_every = every;
      frames_of(scene);
    }
}

/// Expects that the number of data files is the planned one.
Times data_of(const Scene& scene) {
  const Schedule schedule(scene);
  const Times times = times_of(scene, schedule.data());
  EXPECT_EQ(std::int64_t(times.size()), schedule.data_frames());
  return times;
}

TEST(Schedule, WritesDataWithTheFramesOrByItsOwnKeys) {
  Scene scene = scene_of(1, 0.1);
  scene.output.frame_every_steps = 4;
  expect_times({0.1, 0.5, 0.9, 1}, data_of(scene));
  scene.output.data_every = 0.3;
  expect_times({0, 0.3, 0.6, 0.9, 1}, data_of(scene));
  scene.output.data_every.reset();
  scene.output.data_every_steps = 5;
  expect_times({0.1, 0.6, 1}, data_of(scene));
  expect_times({0.1, 0.5, 0.9, 1}, frames_of(scene));
  scene.output.data = {};
  EXPECT_EQ(0, Schedule(scene).data_frames());
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
  Times frames;
  double time = 0;
  for (std::int64_t k = 0; time < 1; ++k) {
    const double after = std::min(1.0, time + (k % 2 == 0 ? 0.013 : 0.05));
    for (const double t : schedule.frame().frames_in({k, time, after, false})) frames.push_back(t);
    time = after;
  }
  EXPECT_EQ(11, schedule.frames());
  expect_times({0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}, frames);
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/pictures.h"

namespace freshet::test {
namespace {

void expect_near(Point a, Point b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(a.z, b.z, 1e-9);
}

/// The maximum distance of the domain's corners from the picture's centre, in half pictures.
double reach(const Scene& s, double time) {
  const View view(pose_at(s, time), 200, 200);
  double most = 0;
  for (int k = 0; k < 8; ++k) {
    const auto seen = view({k & 1 ? 1.0 : -1, k & 2 ? 2.0 : 0, k & 4 ? 1.0 : -1});
    most = std::max({most, std::abs(seen.x - 100) / 100, std::abs(seen.y - 100) / 100});
  }
  return most;
}

TEST(Camera, SeesTheWholeDomainByDefault) {
  EXPECT_NEAR(0.88, reach(deep_scene(""), 0), 1e-9);
  EXPECT_NEAR(0.88, reach(deep_scene("camera.field_of_view = 90"), 0), 1e-9);
  const Scene round = deep_scene("camera.orbit = 90");
  for (double time = 0; time < 4; time += 0.1) EXPECT_LT(reach(round, time), 0.89) << time;
}

TEST(Camera, LooksFromItsPositionAtItsTarget) {
  const Scene s = deep_scene(
      "camera = { position = [0, 1, 10], target = [0, 1, 0], "
      "field_of_view = 90 }");
  const View view(pose_at(s, 0), 200, 200);
  const auto middle = view({0, 1, 0}), right = view({5, 1, 5}), above = view({0, 3, 0});
  EXPECT_NEAR(100, middle.x, 1e-9);
  EXPECT_NEAR(100, middle.y, 1e-9);
  EXPECT_NEAR(10, middle.z, 1e-9);
  EXPECT_NEAR(200, right.x, 1e-9);  // 45 degrees to the right is the edge
  EXPECT_NEAR(80, above.y, 1e-9);
  expect_near({5, 1, 5}, view.eye + right.z * view.ray(right.x, right.y));
}

TEST(Camera, OrbitsToTheRight) {
  const Scene s = deep_scene("camera = { position = [0, 3, 10], target = [0, 1, 0], orbit = 45 }");
  expect_near({0, 3, 10}, pose_at(s, 0).eye);
  expect_near({10, 3, 0}, pose_at(s, 2).eye);
}

TEST(Camera, MovesSmoothlyThroughItsKeyFrames) {
  const Scene s = deep_scene(
      "[[camera]]\ntime = 1\nposition = [0, 0, 10]\n"
      "[[camera]]\ntime = 2\nposition = [4, 0, 10]\nfield_of_view = 50\n"
      "[[camera]]\ntime = 4\nposition = [4, 6, 10]\n");
  expect_near({0, 0, 10}, pose_at(s, 0).eye);
  expect_near({0, 0, 10}, pose_at(s, 1).eye);
  expect_near({4, 0, 10}, pose_at(s, 2).eye);
  expect_near({4, 6, 10}, pose_at(s, 4).eye);
  expect_near({4, 6, 10}, pose_at(s, 9).eye);
  EXPECT_NEAR(50, pose_at(s, 2).field_of_view, 1e-9);
  const auto velocity = [&](double t) {
    return (pose_at(s, t + 1e-6).eye - pose_at(s, t - 1e-6).eye) / 2e-6;
  };
  const Point before = velocity(2 - 1e-5), after = velocity(2 + 1e-5);
  EXPECT_NEAR(before.x, after.x, 1e-3);
  EXPECT_NEAR(before.y, after.y, 1e-3);
  EXPECT_NEAR(2, after.y, 1e-3);  // 6 m in the 3 s between the key frames before and after
}

TEST(Camera, CanLookStraightDown) {
  const Scene s = deep_scene("camera = { position = [0, 9, 0], target = [0, 0, 0] }");
  const View view(pose_at(s, 0), 200, 200);
  EXPECT_GT(view({1, 0, 0}).x, 100);
  EXPECT_GT(view({0, 0, 1}).y, 100);  // the picture's lower half is in front
}

}  // namespace
}  // namespace freshet::test

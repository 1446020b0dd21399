// SPDX-License-Identifier: MIT
// Particles that cross counters from frame to frame.
#include "sim/frame_flows.h"

#include <gtest/gtest.h>

#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

Scene with_counters(const std::string& counters, const std::string& domain = "") {
  return Simulation(
             parse_scene("[domain]\nmax = [1.0, 1.0]\n" + domain +
                             "[particles]\nspacing = 0.1\n[fluid]\nmin = [0, 0]\nmax = [1, "
                             "0.5]\n[solver]\nname = \"wcsph\"\n[time]\nend = 1\nstep = 1e-3\n" +
                             counters,
                         "test.toml"))
      .scene();
}

Frame frame_of(double time, std::vector<std::uint64_t> ids, std::vector<float> x) {
  Frame frame;
  frame.time = time;
  frame.id = std::move(ids);
  frame.x = std::move(x);
  return frame;
}

constexpr const char* middle = "[counter]\ncenter = [0.5, 0]\ndirection = [1, 0]\n";

TEST(FrameFlows, CountAlongTheDirectionMinusAgainstIt) {
  const Scene scene = with_counters(middle);
  FrameFlows flows(scene);
  const auto first = flows.advance(frame_of(0, {0, 1, 2}, {0.4f, 0.1f, 0.6f, 0.1f, 0.4f, 0.2f}));
  EXPECT_EQ(0, first[0].volume);
  const auto second = flows.advance(frame_of(0.5, {0, 1, 2}, {0.6f, 0.1f, 0.7f, 0.1f, 0.6f, 0.2f}));
  EXPECT_NEAR(0.02, second[0].volume, 1e-12);
  EXPECT_NEAR(0.04, second[0].rate, 1e-12);
  const auto third = flows.advance(frame_of(1.0, {0, 1, 2}, {0.6f, 0.1f, 0.4f, 0.1f, 0.6f, 0.2f}));
  EXPECT_NEAR(0.01, third[0].volume, 1e-12);
  EXPECT_NEAR(-0.02, third[0].rate, 1e-12);
}

TEST(FrameFlows, FollowIdsInAnyOrderAndIgnoreThoseOfOneFrame) {
  const Scene scene = with_counters(middle);
  FrameFlows flows(scene);
  flows.advance(frame_of(0, {7, 3, 5}, {0.4f, 0.1f, 0.6f, 0.1f, 0.4f, 0.2f}));
  const auto next =  // 7 crosses; 3 stays; 5 has left; 9 is new
      flows.advance(frame_of(1, {3, 9, 7}, {0.6f, 0.1f, 0.9f, 0.1f, 0.6f, 0.2f}));
  EXPECT_NEAR(0.01, next[0].volume, 1e-12);
}

TEST(FrameFlows, CountOnlyWhatCrossesThePiece) {
  const Scene scene =
      with_counters("[counter]\ncenter = [0.5, 0.3]\ndirection = [1, 0]\nwidth = 0.2\n");
  FrameFlows flows(scene);
  flows.advance(frame_of(0, {0, 1}, {0.4f, 0.1f, 0.4f, 0.3f}));
  const auto next = flows.advance(frame_of(1, {0, 1}, {0.6f, 0.1f, 0.6f, 0.3f}));
  EXPECT_NEAR(0.01, next[0].volume, 1e-12);
}

TEST(FrameFlows, TakeTheShorterWayAcrossPeriodicEnds) {
  const Scene scene = with_counters(
      "[[counter]]\ncenter = [0.5, 0]\ndirection = [1, 0]\n[[counter]]\ncenter = [0.95, "
      "0]\ndirection = [1, 0]\n",
      "periodic = \"x\"\n");
  FrameFlows flows(scene);
  flows.advance(frame_of(0, {0}, {0.9f, 0.1f}));
  const auto next = flows.advance(frame_of(1, {0}, {0.1f, 0.1f}));
  EXPECT_EQ(0, next[0].volume);
  EXPECT_NEAR(0.01, next[1].volume, 1e-12);
}

}  // namespace
}  // namespace freshet::test

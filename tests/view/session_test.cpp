// SPDX-License-Identifier: MIT
#include "view/session.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "cli/files.h"
#include "freshet/checkpoint_file.h"
#include "freshet/run.h"
#include "view/history.h"

namespace freshet::view {
namespace {

namespace fs = std::filesystem;

constexpr const char* drop = R"(
[domain]
max = [1.0, 1.0]
[particles]
spacing = 0.04
[fluid]
shape = "box"
min = [0.3, 0.2]
max = [0.7, 0.6]
[solver]
name = "wcsph"
sound_speed = 30
[time]
end = 1.0
step = 0.0005
)";

class ViewSession : public ::testing::Test {
 protected:
  void SetUp() override {
    write(drop);
    one_.threads = 1;
  }
  void write(const std::string& text) const { std::ofstream(file_) << text; }
  /// The digest of a simulation without a viewer.
  static std::string digest_of(Simulation& sim, int steps) {
    for (int k = 0; k < steps; ++k) sim.step();
    return sim.state_sha256();
  }
  /// Waits until a snapshot fulfils a condition.
  template <class F> static std::shared_ptr<const Snapshot> await(Session& session, F condition) {
    for (int k = 0; k < 400; ++k) {
      const auto s = session.newest();
      if (condition(*s)) return s;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "it did not happen within 4 s";
    return session.newest();
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_.path() / "scene.toml";
  Execution one_;
};

TEST_F(ViewSession, WatchedStepsHaveTheBitsOfUnwatchedOnes) {
  Session session(one_);
  session.open(file_);
  session.step(60);
  for (int k = 0; k < 200; ++k) session.newest();  // reads while it steps
  const std::string watched = session.state_sha256();
  EXPECT_EQ(session.wait()->frame.step, 60);
  Simulation sim(load_scene(file_), one_);
  EXPECT_EQ(watched, digest_of(sim, 60));
}

TEST_F(ViewSession, PlaysAndPauses) {
  Session session(one_);
  session.open(file_);
  EXPECT_FALSE(session.wait()->playing);
  session.set_pace(0);
  session.play(true);
  const auto moving = await(session, [](const Snapshot& s) { return s.frame.step > 5; });
  EXPECT_TRUE(moving->playing);
  session.play(false);
  const auto paused = session.wait();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(session.newest()->frame.step, paused->frame.step);
  EXPECT_FALSE(session.newest()->playing);
}

TEST_F(ViewSession, PaceHoldsTheRunBack) {
  Session session(one_);
  session.open(file_);
  session.wait();
  session.set_pace(0.1);
  session.play(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  session.play(false);
  EXPECT_LT(session.wait()->frame.time, 0.1 * 0.4 + 0.03);
  EXPECT_GT(session.wait()->frame.step, 0);
}

TEST_F(ViewSession, LiveKeyChangesAtOnceAndOthersAtTheNextStart) {
  Session session(one_);
  session.open(file_);
  session.step(20);
  session.change({"domain.gravity", "[4.0, 0.0]"});
  session.change({"particles.spacing", "0.05"});
  const auto changed = session.wait();
  EXPECT_EQ(changed->frame.step, 20);
  EXPECT_EQ(changed->scene->domain.gravity, (Vector{4, 0}));
  EXPECT_EQ(changed->scene->particles.spacing, 0.04);
  ASSERT_EQ(changed->waiting.size(), 1u);
  EXPECT_EQ(changed->waiting[0].first, "particles.spacing");
  session.restart();
  const auto again = session.wait();
  EXPECT_EQ(again->frame.step, 0);
  EXPECT_EQ(again->scene->particles.spacing, 0.05);
  EXPECT_EQ(again->scene->domain.gravity, (Vector{4, 0}));
  EXPECT_TRUE(again->waiting.empty());
}

TEST_F(ViewSession, RefusedChangeIsAProblemAndChangesNothing) {
  Session session(one_);
  session.open(file_);
  session.change({"particles.spacing", "-1"});
  const auto s = session.wait();
  ASSERT_EQ(s->problems.size(), 1u);
  EXPECT_NE(s->problems[0].message.find("particles.spacing"), std::string::npos);
  EXPECT_TRUE(s->waiting.empty());
  session.step(3);
  EXPECT_EQ(session.wait()->frame.step, 3);
}

TEST_F(ViewSession, LogRepeatsARunWithItsChangesAndPushes) {
  const fs::path log = folder_.path() / "actions.toml";
  std::string digest, untouched;
  {
    Session session(one_);
    session.open(file_);
    session.step(20);
    session.wait();
    session.change({"domain.gravity", "[1.5, -3.25]"});
    session.step(10);
    session.wait();
    session.push(Push{{0.5, 0.4, 0}, 0.2, {30.0 / 7, 11, 0}});
    session.step(10);
    session.wait();
    session.push({});
    session.step(20);
    digest = session.state_sha256();
    session.save_log(log);
    EXPECT_TRUE(session.wait()->problems.empty());
  }
  Session again(one_);
  again.replay(read_log(log));
  again.step(60);
  EXPECT_EQ(again.state_sha256(), digest);
  Simulation sim(load_scene(file_), one_);
  EXPECT_NE(digest_of(sim, 60), digest);
}

TEST_F(ViewSession, ErrorsOfASceneAreShownAndTheFileIsLoadedWhenSaved) {
  std::string wrong = drop;
  wrong.replace(wrong.find("spacing"), 7, "spcing");
  write(wrong);
  Session session(one_);
  session.open(file_);
  const auto failed = session.wait();
  EXPECT_EQ(failed->scene, nullptr);
  ASSERT_FALSE(failed->problems.empty());
  bool placed = false;
  for (const Diagnostic& d : failed->problems)
    placed = placed || (d.place.find("scene.toml:5:1") != std::string::npos &&
                        d.message.find("did you mean particles.spacing") != std::string::npos);
  EXPECT_TRUE(placed);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  write(drop);
  const auto loaded = await(session, [](const Snapshot& s) { return s.scene != nullptr; });
  EXPECT_TRUE(loaded->problems.empty());
  EXPECT_GT(loaded->frame.size(), 50u);
}

TEST_F(ViewSession, FinishedRunIsShownFrameByFrame) {
  const fs::path run_folder = folder_.path() / "run";
  RunOptions options;
  options.output = run_folder;
  options.execution = one_;
  run(load_scene(file_, {{"time.end", "0.02"}, {"output.frame_every", "0.005"}}), options);
  Session session(one_);
  session.open(run_folder);
  const auto first = session.wait();
  EXPECT_TRUE(first->finished_run);
  ASSERT_EQ(first->frame_count, 5u);
  session.seek(3);
  EXPECT_EQ(session.wait()->frame.step, 30);
  session.step(1);
  const auto last = session.wait();
  EXPECT_EQ(last->frame_index, 4u);
  EXPECT_TRUE(last->ended);
  session.change({"domain.gravity", "[0.0, 0.0]"});
  EXPECT_FALSE(session.wait()->problems.empty());
  EXPECT_TRUE(session.state_sha256().empty());
}

TEST_F(ViewSession, SavesASceneAndACheckpointOfTheChangedRun) {
  const fs::path scene = folder_.path() / "changed.toml", state = folder_.path() / "c.checkpoint";
  Session session(one_);
  session.open(file_);
  session.step(5);
  session.wait();
  session.change({"solver.sound_speed", "40.0"});
  session.step(5);
  session.wait();
  session.save_scene(scene);
  session.save_checkpoint(state);
  const std::string digest = session.state_sha256();
  EXPECT_EQ(load_scene(scene).solver.sound_speed, 40);
  Simulation sim(load_scene(scene), one_);
  restore_checkpoint(sim, state);
  EXPECT_EQ(sim.state_sha256(), digest);
}

TEST_F(ViewSession, ProblemOfAStepEndsTheRunUntilItStartsAgain) {
  Session session(one_);
  session.open(file_, {{"time.step", "0.02"}, {"solver.sound_speed", "10"}});
  session.step(200);
  auto s = session.wait();
  if (!s->scene) GTEST_SKIP() << s->problems[0].text();
  EXPECT_TRUE(s->failed);
  EXPECT_FALSE(s->problems.empty());
  session.play(true);
  EXPECT_FALSE(session.wait()->playing);
}

/// `freshet view --replay LOG --steps 4 --screenshot FILE` waited for ever.
TEST_F(ViewSession, StepsOfWhatCannotBeOpenedAreNotWaitedFor) {
  Session session(one_);
  session.open(folder_.path() / "missing.toml");
  session.step(4);
  EXPECT_FALSE(session.wait()->problems.empty());
  session.open(file_);
  session.step(3);
  EXPECT_EQ(3, session.wait()->frame.step);
  session.step(std::numeric_limits<std::int64_t>::max());
  session.step(std::numeric_limits<std::int64_t>::max());
  session.play(false);
  EXPECT_FALSE(session.wait()->playing);
}

TEST_F(ViewSession, HistoryHasARowPerSnapshotAndThinsOut) {
  Session session(one_);
  session.open(file_);
  History history;
  auto first = *session.wait();
  for (int k = 0; k < 5000; ++k) {
    first.frame.time = 0.001 * k;
    history.add(first);
  }
  EXPECT_LT(history.times().size(), 2048u);
  EXPECT_GT(history.times().size(), 512u);
  EXPECT_GT(history.times().back(), 4.9f);
  for (const History::Series& s : history.series())
    EXPECT_EQ(s.values.size(), history.times().size()) << s.name;
  ++first.run;
  history.add(first);
  EXPECT_EQ(history.times().size(), 1u);
}

}  // namespace
}  // namespace freshet::view

// SPDX-License-Identifier: MIT
// Checkpoints with the right digest and contents that no run writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <span>

#include "cli/files.h"
#include "freshet/error.h"
#include "io/checkpoint.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

class InvalidCheckpoint : public ::testing::Test {
 protected:
  using Change = std::function<void(RunCheckpoint&)>;

  /// A checkpoint with an entry in every list.
  static RunCheckpoint made() {
    Simulation sim = simulation_of(R"([domain]
max = [1.0, 1.0]
[particles]
spacing = 0.1
[fluid]
min = [0.0, 0.0]
max = [0.5, 0.5]
[solver]
name = "wcsph"
[time]
end = 1.0
step = 0.001
)");
    for (int k = 0; k < 3; ++k) sim.step();
    RunCheckpoint c = sim.checkpoint();
    c.run.series["frames"] = {{0, 0.5}, 1};
    c.run.tables["observables.csv"] = {"step\n", 9, 7, "a digest", "another"};
    c.run.tables["probes/a b.csv"] = {};
    c.run.written["observables"] = 2;
    c.run.flows = {{"outlet", "drain", 3, 0.1, 0, 0}, {"counter", "back", -3, 0.1, 0, 0}};
    c.watch.warnings = {{"speed", "fast"}};
    c.watch.tracks = {{true, false, 1}};
    return c;
  }
  static std::string refused(const Change& change) {
    static const RunCheckpoint valid = made();
    RunCheckpoint c = valid;
    change(c);
    try {
      decode_checkpoint(encode_checkpoint(c), "step.h5");
      return "read without an error";
    } catch (const Error& e) {
      EXPECT_EQ(Error::Kind::run, e.kind());
      return e.what();
    }
  }
  static Checkpoint::Array& array(RunCheckpoint& c, const std::string& name) {
    return *std::find_if(c.arrays.begin(), c.arrays.end(),
                         [&](const StateArray& a) { return a.name == name; });
  }
  static void set(Checkpoint::Array& a, std::size_t k, Real value) {
    std::memcpy(a.bytes.data() + k * sizeof value, &value, sizeof value);
  }
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr std::int64_t most = std::int64_t(1) << 53;
};

TEST_F(InvalidCheckpoint, IsNotWhatARunWrites) {
  EXPECT_EQ("read without an error", refused([](RunCheckpoint&) {}));
}

TEST_F(InvalidCheckpoint, HasCountersOrTimesOutOfRange) {
  EXPECT_EQ(
      "step.h5: error: this checkpoint is invalid: the number of steps is -1, not 0 to 2^53; use "
      "another checkpoint",
      refused([](RunCheckpoint& c) { c.steps = -1; }));
  EXPECT_EQ("read without an error", refused([](RunCheckpoint& c) { c.steps = most; }));
  const Change changes[] = {
      [](RunCheckpoint& c) { c.steps = most + 1; },
      [](RunCheckpoint& c) { c.time = -0.1; },
      [](RunCheckpoint& c) { c.time_steps.last = -1; },
      [](RunCheckpoint& c) { c.time_steps.retried = -1; },
      [](RunCheckpoint& c) { c.time_steps.ruled["sound"] = -1; },
      [](RunCheckpoint& c) {
        c.solves = {{"density", 0.1, 1, 1, -1}};
      },
      [](RunCheckpoint& c) { c.watch.tracks.clear(); },
      [](RunCheckpoint& c) { c.watch.tracks.push_back({}); },
      [](RunCheckpoint& c) { c.watch.tracks[0].steps = -1; },
      [](RunCheckpoint& c) { c.watch.warnings[0].looks = -1; },
      [](RunCheckpoint& c) { c.watch.warnings[0].first_time = -1; },
      [](RunCheckpoint& c) { c.watch.steps_watched = -1; },
      [](RunCheckpoint& c) { c.watch.not_converged = {-1}; },
      [](RunCheckpoint& c) { c.run.seconds = -1; },
      [](RunCheckpoint& c) { c.run.observed.time = -1; },
      [](RunCheckpoint& c) { c.run.written["observables"] = -1; },
      [](RunCheckpoint& c) { c.run.flows[0].particles = -1; },
      [](RunCheckpoint& c) { c.run.flows[1].waiting = -1; },
      [](RunCheckpoint& c) { c.run.series["frames"].scheduled = 3; },
      [](RunCheckpoint& c) { c.run.series["frames"].times[1] = -1; },
      [](RunCheckpoint& c) { c.run.tables["observables.csv"].scheduled = 10; },
      [](RunCheckpoint& c) { c.run.tables["observables.csv"].bytes = std::size_t(-1); },
  };
  for (const Change& change : changes)
    EXPECT_TRUE(contains(refused(change), "this checkpoint is invalid: "))
        << "change " << &change - changes;
}

TEST_F(InvalidCheckpoint, NamesATableOutsideTheRunFolder) {
  for (const char* name : {"../observables.csv", "/tmp/observables.csv", "probes/../../a.csv",
                           "./observables.csv", "scene.toml", "", ".."})
    EXPECT_TRUE(contains(refused([&](RunCheckpoint& c) { c.run.tables[name] = {}; }),
                         "is not the name of a table in the run folder"))
        << name;
}

TEST_F(InvalidCheckpoint, HasWrongArrays) {
  const Change changes[] = {
      [](RunCheckpoint& c) { array(c, "fluid/x").count = 1; },
      [](RunCheckpoint& c) { array(c, "fluid/x").count = -1; },
      [](RunCheckpoint& c) { array(c, "fluid/x").components = 1; },
      [](RunCheckpoint& c) { array(c, "fluid/v").name = "velocity"; },
      [](RunCheckpoint& c) { array(c, "fluid/v").name = "fluid/v v"; },
      [](RunCheckpoint& c) { set(array(c, "fluid/x"), 3, Real(nan)); },
      [](RunCheckpoint& c) { set(array(c, "fluid/v"), 0, std::numeric_limits<Real>::infinity()); },
      [](RunCheckpoint& c) {
        auto& ids = array(c, "fluid/id");
        std::copy_n(ids.bytes.begin(), 8, ids.bytes.begin() + 8);
      },
      [](RunCheckpoint& c) { array(c, "fluid/id").bytes[7] = std::byte(255); },
  };
  for (const Change& change : changes)
    EXPECT_TRUE(contains(refused(change), "this checkpoint is invalid: "))
        << "change " << &change - changes;
  EXPECT_TRUE(contains(refused(changes[5]), "fluid/x has a number that is NaN or infinite"));
}

TEST_F(InvalidCheckpoint, HasWrongBodies) {
  const auto with_bodies = [](const std::vector<double>& numbers) {
    return refused([&](RunCheckpoint& c) {
      Checkpoint::Array a{{"bodies/state", nullptr, std::int64_t(numbers.size()), 1,
                           StateArray::Number::float64, StateArray::Role::other},
                          {}};
      const auto bytes = std::as_bytes(std::span(numbers));
      a.bytes.assign(bytes.begin(), bytes.end());
      c.arrays.push_back(a);
    });
  };
  std::vector<double> body(19);
  body[6] = 1;
  EXPECT_EQ("read without an error", with_bodies(body));
  EXPECT_TRUE(contains(with_bodies({1, 2, 3}), "19 numbers per body"));
  body[0] = nan;
  EXPECT_TRUE(contains(with_bodies(body), "NaN or infinite"));
  body[0] = 0;
  body[6] = 0;
  EXPECT_TRUE(contains(with_bodies(body), "not a unit quaternion"));
}

}  // namespace
}  // namespace freshet::test

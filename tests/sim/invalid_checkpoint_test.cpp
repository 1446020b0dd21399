// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "cli/files.h"
#include "freshet/checkpoint.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// A jet of one liquid onto another, with an outlet and a counter.
class InvalidRestore : public ::testing::Test {
 protected:
  static Simulation jet() {
    return simulation_of(R"([domain]
max = [0.5, 0.5]
[walls]
[particles]
spacing = 0.05
[[fluid]]
min = [0, 0]
max = [0.5, 0.1]
[[fluid]]
rest_density = 900
min = [0, 0.1]
max = [0.5, 0.2]
[[inlet]]
center = [0.15, 0.35]
direction = [1, 0]
width = 0.2
speed = 2
[[outlet]]
min = [0.4, 0]
max = [0.5, 0.5]
[[counter]]
center = [0.3, 0.25]
direction = [1, 0]
[solver]
name = "wcsph"
sound_speed = 30
[time]
end = 0.5
step = 0.001
)");
  }
  InvalidRestore() : source_(jet()), target_(jet()) {
    for (int k = 0; k < 40; ++k) source_.step();
    for (int k = 0; k < 15; ++k) target_.step();
  }
  /// Restores a changed checkpoint; a rejected one must change nothing.
  std::string refused(const std::function<void(Checkpoint&)>& change) {
    Checkpoint c = source_.checkpoint();
    change(c);
    const std::string before = target_.kept_sha256();
    const std::size_t particles = target_.fluid().size();
    try {
      target_.restore(c);
      return "restored without an error";
    } catch (const Error& e) {
      EXPECT_EQ(before, target_.kept_sha256());
      EXPECT_EQ(particles, target_.fluid().size());
      EXPECT_EQ(15, target_.steps_done());
      EXPECT_TRUE(e.kind() == Error::Kind::run || contains(e.what(), "not of this scene"));
      return e.what();
    }
  }
  template <class T> std::string refused(const std::string& name, std::size_t k, T value) {
    return refused([&](Checkpoint& c) {
      const auto a = std::find_if(c.arrays.begin(), c.arrays.end(),
                                  [&](const StateArray& b) { return b.name == name; });
      ASSERT_NE(a, c.arrays.end()) << name;
      std::memcpy(a->bytes.data() + k * sizeof value, &value, sizeof value);
    });
  }

  Simulation source_, target_;
};

TEST_F(InvalidRestore, AcceptsWhatARunWrites) {
  EXPECT_EQ("restored without an error", refused([](Checkpoint&) {}));
  EXPECT_EQ(source_.kept_sha256(), target_.kept_sha256());
}

TEST_F(InvalidRestore, RejectsIndicesOutOfRange) {
  EXPECT_TRUE(contains(refused("fluid/kind", 0, 2), "fluid/kind has 2, not 0 to 1"));
  EXPECT_TRUE(contains(refused("fluid/kind", 0, -1), "fluid/kind has -1"));
  EXPECT_TRUE(contains(refused("fluid/held", 0, 1000), "fluid/held has 1000"));
  EXPECT_TRUE(contains(refused("fluid/held", 0, -1), "fluid/held has -1"));
  EXPECT_TRUE(contains(refused("flows/next_id", 0, std::uint64_t(3)), "the next id is 3"));
  EXPECT_TRUE(contains(refused("flows/next_id", 0, std::uint64_t(-1)), "the next id is"));
}

TEST_F(InvalidRestore, RejectsCountsAndClocksOutOfRange) {
  EXPECT_TRUE(contains(refused("flows/counts", 0, std::int64_t(-1)), "counter is -1"));
  EXPECT_EQ("restored without an error", refused("flows/counts", 1, std::int64_t(-1)));
}

TEST_F(InvalidRestore, RejectsInletsThatWouldNotEnd) {
  const auto layers = [&](std::size_t k, std::uint64_t n) {
    return refused("flows/inlet_0_layers", k, n);
  };
  EXPECT_TRUE(contains(layers(0, 0), "inlet 0 has 0 layers"));
  EXPECT_TRUE(contains(layers(0, 1000000), "inlet 0 has 1000000 layers"));
  EXPECT_TRUE(contains(layers(1, 1000000), "1000000 of them past its opening"));
  EXPECT_TRUE(contains(layers(2, std::uint64_t(-1)), "waiting particles"));
  EXPECT_TRUE(contains(refused([](Checkpoint& c) { c.time = 1e9; }), "have passed it"));
  EXPECT_TRUE(contains(refused("flows/inlet_0_crossings", 0, 1 / 0.0), "NaN or infinite"));
}

TEST_F(InvalidRestore, RejectsUnknownAndResizedArrays) {
  EXPECT_TRUE(contains(refused([](Checkpoint& c) {
                         c.arrays.push_back(c.arrays.back());
                         c.arrays.back().name = "fluid/other";
                       }),
                       "it has fluid/other, which this scene does not have"));
  EXPECT_TRUE(contains(refused([](Checkpoint& c) { c.arrays.push_back(c.arrays.back()); }),
                       "is there twice"));
  EXPECT_TRUE(contains(refused([](Checkpoint& c) { c.arrays.front().bytes.pop_back(); }), "bytes"));
  EXPECT_TRUE(contains(refused([](Checkpoint& c) { c.steps = -1; }), "number of steps is -1"));
}

}  // namespace
}  // namespace freshet::test

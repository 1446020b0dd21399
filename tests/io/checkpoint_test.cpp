// SPDX-License-Identifier: MIT
#include "io/checkpoint.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "cli/files.h"
#include "sim/small_scenes.h"

namespace freshet {
namespace {

constexpr const char* scene = R"([domain]
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
)";

RunCheckpoint checkpoint() {
  Simulation sim = test::simulation_of(scene);
  for (int k = 0; k < 3; ++k) sim.step();
  RunCheckpoint c = sim.checkpoint();
  c.run.scene_name = "a name";
  c.run.series["frames"] = {{0, 0.5}, 1};
  c.run.tables["observables.csv"] = {"step\n", 9, 7, "a digest", "another"};
  c.run.written["observables"] = 2;
  c.run.wall_forces = {{0.1, 1e-300}, {-3, 0}};
  return c;
}

std::string message_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

std::string refusal(const std::string& bytes) {
  return message_of([&] { decode_checkpoint(bytes, "step.h5"); });
}

TEST(CheckpointFile, DecodesToItsContents) {
  const RunCheckpoint a = checkpoint(), b = decode_checkpoint(encode_checkpoint(a), "step.h5");
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(3, b.steps);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.run.wall_forces, b.run.wall_forces);
  EXPECT_EQ(a.run.tables, b.run.tables);
  EXPECT_EQ(a.run.series, b.run.series);
  EXPECT_EQ(a.run.written, b.run.written);
  EXPECT_EQ("a name", b.run.scene_name);
  ASSERT_EQ(a.arrays.size(), b.arrays.size());
  for (const auto& array : a.arrays) {
    const auto same = std::find_if(b.arrays.begin(), b.arrays.end(),
                                   [&](const auto& other) { return other.name == array.name; });
    ASSERT_NE(same, b.arrays.end()) << array.name;
    EXPECT_EQ(array.bytes, same->bytes) << array.name;
    EXPECT_EQ(array.count, same->count) << array.name;
  }
  EXPECT_TRUE(encode_checkpoint(a) == encode_checkpoint(checkpoint()))
      << "equal states must give equal bytes";
}

TEST(CheckpointFile, KeepsSolveStatistics) {
  RunCheckpoint a = checkpoint();
  a.time_steps.retried = 5;
  a.retries_help = false;
  a.solves = {{"divergence", 0.001, 20, 30, 4, 0, 2, 0.1, 1.0 / 3},
              {"density", 0.0001, 21, 50, 9, 1, 3, 1e-300, 0.2}};
  const RunCheckpoint b = decode_checkpoint(encode_checkpoint(a), "step.h5");
  EXPECT_EQ(5, b.time_steps.retried);
  EXPECT_FALSE(b.retries_help);
  EXPECT_TRUE(decode_checkpoint(encode_checkpoint(checkpoint()), "step.h5").retries_help);
  ASSERT_EQ(2u, b.solves.size());
  for (std::size_t k = 0; k < 2; ++k) {
    const SolveStatistics &given = a.solves[k], &got = b.solves[k];
    EXPECT_EQ(given.name, got.name);
    EXPECT_EQ(given.tolerance, got.tolerance);
    EXPECT_EQ(given.solves, got.solves);
    EXPECT_EQ(given.iterations, got.iterations);
    EXPECT_EQ(given.most_iterations, got.most_iterations);
    EXPECT_EQ(given.not_converged, got.not_converged);
    EXPECT_EQ(given.last_iterations, got.last_iterations);
    EXPECT_EQ(given.last_error, got.last_error);
    EXPECT_EQ(given.worst_error, got.worst_error);
  }
}

TEST(CheckpointFile, StoresNanAndInfinityAsTheLargestNumber) {
  constexpr double most = std::numeric_limits<double>::max();
  RunCheckpoint a = checkpoint();
  a.solves.resize(1);
  a.solves[0].last_error = std::numeric_limits<double>::quiet_NaN();
  a.solves[0].worst_error = std::numeric_limits<double>::infinity();
  const RunCheckpoint b = decode_checkpoint(encode_checkpoint(a), "step.h5");
  ASSERT_EQ(1u, b.solves.size());
  EXPECT_EQ(most, b.solves[0].last_error);
  EXPECT_EQ(most, b.solves[0].worst_error);
}

TEST(CheckpointFile, IsRejectedWithBytesMissingOrAdded) {
  const std::string bytes = encode_checkpoint(checkpoint());
  for (const std::size_t size : {std::size_t(0), std::size_t(10), std::size_t(511),
                                 std::size_t(512), bytes.size() / 2, bytes.size() - 1}) {
    const std::string words = refusal(bytes.substr(0, size));
    EXPECT_TRUE(words.starts_with("step.h5: error: this checkpoint is torn: ")) << words;
  }
  EXPECT_NE(std::string::npos, refusal(bytes + "x").find("is damaged"));
}

TEST(CheckpointFile, ThatIsEmptyIsRejectedAsEmpty) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "step.h5", "");
  EXPECT_EQ((folder / "step.h5").string() + ": error: this file is empty; use another checkpoint",
            message_of([&] { read_checkpoint(folder / "step.h5"); }));
}

TEST(CheckpointFile, IsRejectedWithAFlippedBit) {
  const std::string bytes = encode_checkpoint(checkpoint());
  const auto flipped = [&](std::size_t at, int bit) {
    std::string other = bytes;
    other[at] = char(other[at] ^ (1 << bit));
    return refusal(other);
  };
  for (std::size_t at = 0; at < 512; ++at)
    for (int bit = 0; bit < 8; ++bit) EXPECT_NE("no error", flipped(at, bit)) << at;
  for (std::size_t at = 512; at < bytes.size(); at += 997)
    EXPECT_EQ(
        "step.h5: error: this checkpoint is damaged: its bytes are not those that its "
        "SHA-256 was made of",
        flipped(at, int(at % 8)))
        << at;
}

TEST(CheckpointFile, OfAnotherFormatIsRejectedWithItsVersion) {
  std::string bytes = encode_checkpoint(checkpoint());
  bytes[bytes.find("format 6") + 7] = '1';
  bytes[bytes.find("version 0.1.0") + 8] = '9';
  EXPECT_EQ(
      "step.h5: error: this checkpoint has format 1, written by Freshet 9.1.0; this program, "
      "Freshet 0.1.0, reads format 6; go on with that version",
      refusal(bytes));
}

TEST(CheckpointFile, WithoutAHeaderIsRejected) {
  EXPECT_EQ("step.h5: error: this is no checkpoint of Freshet, or its first bytes are damaged",
            refusal(std::string(2000, 'x')));
}

TEST(Restore, RejectsAnotherSceneAndKeepsTheState) {
  const RunCheckpoint c = checkpoint();
  const auto with = [&](const std::vector<Override>& changes) {
    Simulation sim(parse_scene(scene, "test.toml", changes));
    const std::string before = sim.state_sha256();
    const std::string words = message_of([&] { sim.restore(c); });
    EXPECT_EQ(before, sim.state_sha256());
    return words;
  };
  EXPECT_NE(std::string::npos, with({{"particles.spacing", "0.05"}}).find("another resolution"));
  EXPECT_NE(std::string::npos, with({{"solver.name", "delta_sph"}}).find("another solver"));
  EXPECT_NE(std::string::npos, with({{"domain.max", "[1.1, 1.0]"}, {"walls.x_max", "open"}})
                                   .find("this checkpoint is not of this scene"));
}

// Arrays of the same sizes do not make two scenes the same.
TEST(Restore, RejectsASceneThatDiffersInAKeyOfTheSteps) {
  const RunCheckpoint c = checkpoint();
  const auto restored = [&](const std::vector<Override>& changes) {
    Simulation sim(parse_scene(scene, "test.toml", changes));
    const std::string before = sim.state_sha256(), words = message_of([&] { sim.restore(c); });
    EXPECT_EQ(words == "no error", before != sim.state_sha256());
    return words;
  };
  const std::string refused = "error: this checkpoint is not of this scene: ";
  EXPECT_EQ(refused + "time.step differs; restore it into a simulation of its own scene",
            restored({{"time.step", "0.0005"}}));
  EXPECT_TRUE(
      restored({{"domain.gravity", "[0, -1.62]"}}).starts_with(refused + "domain.gravity differs"));
  EXPECT_EQ("no error", restored({{"time.end", "3"}, {"title", "t"}, {"picture.width", "64"}}));
  EXPECT_EQ("no error", restored({{"solver.backend", "reference"}}));
}

}  // namespace
}  // namespace freshet

// SPDX-License-Identifier: MIT
// Checkpoints of a program that embeds the library.
#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/checkpoint_file.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

const std::string scene =
    "domain.max = [1, 1]\nparticles.spacing = 0.02\nfluid = { min = [0, 0], max = [0.5, 0.5] }\n"
    "solver.name = \"delta_sph\"\ntime = { end = 1, step = 1e-4 }\n";

TEST(CheckpointFiles, ResumeToTheSameBits) {
  const TemporaryFolder folder;
  Simulation first = simulation_of(scene), second = simulation_of(scene);
  for (int k = 0; k < 5; ++k) first.step();
  save_checkpoint(first, folder / "five.h5");
  for (int k = 0; k < 5; ++k) first.step();
  restore_checkpoint(second, folder / "five.h5");
  EXPECT_EQ(5, second.steps_done());
  for (int k = 0; k < 5; ++k) second.step();
  EXPECT_EQ(first.state_sha256(), second.state_sha256());
  EXPECT_EQ(first.kept_sha256(), second.kept_sha256());
}

TEST(CheckpointFiles, HaveAboutThePredictedSize) {
  const TemporaryFolder folder;
  Simulation sim = simulation_of(scene);
  sim.step();
  save_checkpoint(sim, folder / "one.h5");
  const double size = double(fs::file_size(folder / "one.h5"));
  EXPECT_NEAR(size, double(checkpoint_bytes(sim)), 0.1 * size);
}

TEST(CheckpointFiles, FailuresLeaveTheSimulationUnchanged) {
  const TemporaryFolder folder;
  Simulation sim = simulation_of(scene);
  sim.step();
  const std::string before = sim.state_sha256();
  write_text(folder / "none.h5", "nothing");
  EXPECT_THROW(restore_checkpoint(sim, folder / "none.h5"), Error);
  EXPECT_THROW(restore_checkpoint(sim, folder / "missing.h5"), Error);
  EXPECT_THROW(save_checkpoint(sim, folder / "no/such/folder/one.h5"), Error);
  EXPECT_EQ(before, sim.state_sha256());
}

}  // namespace
}  // namespace freshet::test

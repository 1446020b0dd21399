// SPDX-License-Identifier: MIT
// What a run holds in memory does not grow with its steps, but for a line of its manifest per file.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cstdint>

#include "cli/files.h"
#include "freshet/run.h"

namespace freshet::test {
namespace {

TEST(Growth, IsBoundedByTableAndManifestOver10000Steps) {
  const TemporaryFolder folder;
  RunOptions options;
  options.output = folder / "run";
  options.scene_name = "growth";
  options.execution.threads = 1;
  // minimum over a range of steps: queued background jobs make the memory fluctuate
  std::size_t early = SIZE_MAX, late = SIZE_MAX;
  options.after_step = [&](const Simulation& sim, double) {
    const std::size_t held = mallinfo2().uordblks + mallinfo2().hblkhd;
    if (sim.steps_done() > 1000 && sim.steps_done() <= 3000) early = std::min(early, held);
    if (sim.steps_done() > 8000) late = std::min(late, held);
    return true;
  };
  const Scene scene = parse_scene(
      "domain.max = [1, 1]\nparticles.spacing = 0.1\nfluid = { min = [0, 0], max = [0.6, 0.4] }\n"
      "solver = { name = \"wcsph\", sound_speed = 30.0 }\ntime = { end = 10, step = 1e-3 }\n"
      "picture = { width = 64, height = 48 }\n"
      "[output]\nframe_every_steps = 100\nobservables_every_steps = 100\n"
      "checkpoint_every_steps = 500\ndata = [\"vtp\", \"ply\", \"csv\", \"hdf5\"]\n",
      "growth.toml");
  run(scene, options);
  const std::size_t files = files_below(folder / "run").size();
  EXPECT_GT(files, 400u);
  EXPECT_LT(late, early + 1000 * files) << "it held " << early << " bytes early on";
}

}  // namespace
}  // namespace freshet::test

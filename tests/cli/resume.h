// SPDX-License-Identifier: MIT
/// Runs that are resumed: the scene and the comparison of what they leave.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/files.h"
#include "cli/process.h"

namespace freshet::test {

// Frames, observables and checkpoints are written at different steps.
inline constexpr const char* resumable_scene = R"([domain]
max = [1.0, 1.0]
[particles]
spacing = 0.05
[fluid]
min = [0.0, 0.0]
max = [0.4, 0.6]
[[wall]]
shape = "sphere"
center = [0.7, 0.2]
radius = 0.1
method = "reflection"
[solver]
name = "wcsph"
[time]
end = 0.25
step = 0.0005
[output]
frame_every_steps = 33
observables_every_steps = 7
checkpoint_every_steps = 20
[picture]
width = 64
height = 64
)";

class Resume : public ::testing::Test {
 protected:
  Resume() { write_text(folder / "scene.toml", resumable_scene); }
  std::vector<std::string> arguments(const std::string& name,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"run", (folder / "scene.toml").string(), "--output",
                                 (folder / name).string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  ProcessResult resume(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"resume", (folder / name).string()};
    all.insert(all.end(), more.begin(), more.end());
    return freshet(all);
  }
  std::vector<fs::path> checkpoints(const std::string& name) const {
    std::vector<fs::path> all;
    if (fs::exists(folder / name / "checkpoints"))
      for (const auto& entry : fs::directory_iterator(folder / name / "checkpoints"))
        all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
  }
  /// Expects equal bytes of state, tables and pictures in both runs.
  void expect_same_run(const std::string& a, const std::string& b) const {
    const auto files = files_below(folder / a);
    EXPECT_EQ(files, files_below(folder / b));
    for (const std::string& file : files) {
      if (file.ends_with(".json") || file == "scene.toml" || file.starts_with("checkpoints/"))
        continue;
      EXPECT_EQ(read_text(folder / a / file), read_text(folder / b / file)) << file;
    }
    for (const char* key : {"state_sha256", "kept_sha256", "steps", "time_steps", "statistics"})
      EXPECT_EQ(report_of(folder / a).at(key), report_of(folder / b).at(key)) << key;
    expect_whole_run(folder / b);
  }
  const TemporaryFolder folder;
};

}  // namespace freshet::test

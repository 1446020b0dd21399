// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "freshet/simulation.h"

namespace freshet {

/// A film of the run, its pictures rendered apart from the frames and piped to ffmpeg.
struct VideoOptions {
  std::filesystem::path file;  ///< *.mp4 or *.gif
  double fps = 30;             ///< pictures per simulated second, shown at that rate
};

struct RunOptions {
  std::filesystem::path output;      ///< the run's folder
  bool overwrite = false;            ///< replace the run that the folder holds
  std::string scene_name;            ///< for report.json
  std::vector<std::string> command;  ///< for manifest.json
  Execution execution;
  std::optional<VideoOptions> video;
  /// Called after every step with the seconds that steps have taken so far; false ends the run,
  /// with all that was written whole.
  std::function<bool(const Simulation&, double seconds)> after_step;
};

/// Runs a scene into a folder: frames/frame_0000.png ..., result.png, observables.csv, scene.toml,
/// report.json and manifest.json, each whole or absent.
///
/// Throws Error (kind scene) if the folder holds a run (unless `overwrite`) or another run writes
/// into it; Error (kind run) if a step or a write failed: what was written before stays.
Report run(const Scene& scene, const RunOptions& options);

}  // namespace freshet

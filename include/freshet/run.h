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

/// Called after every step with the seconds that steps have taken so far; false ends the run, with
/// all that was written whole and a checkpoint.
using AfterStep = std::function<bool(const Simulation&, double seconds)>;

struct RunOptions {
  std::filesystem::path output;      ///< the run's folder
  bool overwrite = false;            ///< replace the run that the folder holds
  std::string scene_name;            ///< for report.json
  std::vector<std::string> command;  ///< for manifest.json
  Execution execution;
  std::optional<VideoOptions> video;
  AfterStep after_step;
};

/// Runs a scene into a folder: frames/frame_0000.png ..., result.png, observables.csv, scene.toml,
/// report.json, manifest.json and the last two checkpoints, each whole or absent.
///
/// Throws Error (kind scene) if the folder holds a run (unless `overwrite`) or another run writes
/// into it; Error (kind run) if a step or a write failed: what was written before stays.
Report run(const Scene& scene, const RunOptions& options);

struct ResumeOptions {
  std::filesystem::path folder;  ///< of a run that was interrupted, killed, or is to be prolonged
  std::vector<Override> overrides;  ///< of time.end, output, picture, camera and checks
  std::vector<std::string> command;
  Execution execution;
  AfterStep after_step;
  /// Gets what is wrong with checkpoints newer than the one that the run goes on from.
  std::function<void(const std::vector<Diagnostic>&)> warn;
};

/// Goes on from the newest whole checkpoint to the same bits, and the same files, as the run would
/// have come to without a stop.
///
/// Throws Error (kind scene) if the folder holds no run, another run writes into it, or a key may
/// not change; Error (kind run) as run does, or if no checkpoint is whole.
Report resume(const ResumeOptions& options);

}  // namespace freshet

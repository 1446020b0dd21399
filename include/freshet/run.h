// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>

#include "freshet/simulation.h"

namespace freshet {

/// Video output. Its pictures are drawn separately from the frames.
struct VideoOptions {
  std::filesystem::path file;  ///< *.mp4, *.gif or *.webp
  double fps = 30;             ///< pictures per second of video
  double speed = 1;            ///< simulated seconds per second of video; below 1: slow motion
};

/// Called after every step with the wall time of the steps so far [s]. Returning false ends the
/// run: it writes a checkpoint, and all files are complete.
using AfterStep = std::function<bool(const Simulation&, double seconds)>;

struct RunOptions {
  std::filesystem::path output;      ///< the run folder
  bool overwrite = false;            ///< replace an existing run in the folder
  std::string scene_name;            ///< for report.json
  std::vector<std::string> command;  ///< for manifest.json
  Execution execution;
  std::optional<VideoOptions> video;
  AfterStep after_step;
};

/// Runs a scene and writes a run folder: frames/frame_0000.png ..., result.png, observables.csv,
/// scene.toml, report.json, manifest.json and the last two checkpoints. The pictures of a video are
/// written to video/ and encoded at the end. A failed write leaves no
/// partial file.
///
/// Throws Error (kind scene), before anything changes, if the folder holds a run (unless
/// `overwrite`), another run writes into it, a file that no run wrote would be replaced, or a
/// folder in it is a symbolic link. Throws Error (kind run) if a step or a write failed; files
/// written before stay.
Report run(const Scene& scene, const RunOptions& options);

struct ResumeOptions {
  std::filesystem::path folder;  ///< of a run that was interrupted or killed, or that is extended
  std::vector<Override> overrides;  ///< of time.end, output, surface, picture, camera and checks
  std::vector<std::string> command;
  Execution execution;
  AfterStep after_step;
  /// Receives the defects of the checkpoints newer than the one that the run resumes from.
  std::function<void(const std::vector<Diagnostic>&)> warn;
  /// Another file for the video of the run; its pictures per second stay. Empty: the same file.
  std::filesystem::path video = {};
  /// Receives the file of the run's video before the first step, if the run makes one.
  std::function<void(const std::filesystem::path&)> tell_video = {};
};

/// Resumes a run from its newest valid checkpoint, its video included. The result has the same bits
/// and the same files as an uninterrupted run.
///
/// The scene is that of scene.toml in the folder, with the overrides.
///
/// Throws Error (kind scene) if the folder holds no run, another run writes into it, an override
/// changes a key that may not change, time.end is before the checkpoint, or the checkpoint is of
/// another scene or was not written by the run. Throws Error (kind run) if no checkpoint is valid,
/// or if a step or a write failed.
Report resume(const ResumeOptions& options);

}  // namespace freshet

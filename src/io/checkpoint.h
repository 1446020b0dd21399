// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "freshet/checkpoint.h"
#include "freshet/vector.h"

namespace freshet {

/// The state of the outputs of a run.
struct RunRecord {
  std::string scene_name;           ///< for report.json
  std::int64_t frames = 0;          ///< pictures
  std::vector<double> data_times;   ///< of data files [s]
  double seconds = 0;               ///< that steps took
  std::string observables;          ///< observables.csv so far
  std::vector<std::string> probes;  ///< the tables of the probes so far
  std::vector<Vector> wall_forces;  ///< as last observed
  std::vector<Flow> flows;          ///< the same
  std::string bodies;               ///< bodies.csv so far
  /// After which step each was last written.
  std::int64_t observed_step = -1, frame_step = -1, data_step = -1;
  /// What the schedule alone has brought; the rest was the end's, which a longer run does not have.
  std::int64_t scheduled_frames = 0;
  std::size_t scheduled_data = 0;
  std::size_t scheduled_observables = 0;      ///< bytes
  std::vector<std::size_t> scheduled_probes;  ///< bytes
  std::size_t scheduled_bodies = 0;
  std::int64_t bodies_step = -1;
};

/// A checkpoint of a simulation, with the state of the outputs of its run.
struct RunCheckpoint : Checkpoint {
  RunCheckpoint() = default;
  RunCheckpoint(Checkpoint simulation) : Checkpoint(std::move(simulation)) {}
  RunRecord run;
};

/// The bytes of a checkpoint's file: a block of 512 bytes with the format, the program's version
/// and the SHA-256 of the whole file, then HDF5, which h5dump and the like read past that block.
std::string encode_checkpoint(const RunCheckpoint& checkpoint);

/// Throws Error (kind run; its place is `file`) if the bytes are no checkpoint, torn, damaged, or
/// of another version's format.
RunCheckpoint decode_checkpoint(std::string_view bytes, const std::string& file);
RunCheckpoint read_checkpoint(const std::filesystem::path& file);
/// The checkpoints in the folder of a run, the newest first.
std::vector<std::filesystem::path> checkpoints_of(const std::filesystem::path& folder);

}  // namespace freshet

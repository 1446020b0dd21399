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
  std::vector<double> data_times;   ///< times of the data files [s]
  double seconds = 0;               ///< wall time of the steps
  std::string observables;          ///< observables.csv so far
  std::vector<std::string> probes;  ///< the tables of the probes so far
  std::vector<Vector> wall_forces;  ///< at the last row of observables
  std::vector<Flow> flows;          ///< at the last row of observables
  std::string bodies;               ///< bodies.csv so far
  /// The step after which each output was last written; -1: never.
  std::int64_t observed_step = -1, frame_step = -1, data_step = -1;
  /// The outputs due by the schedule. Outputs beyond these were written at the end of the run, and
  /// a prolonged run drops them.
  std::int64_t scheduled_frames = 0;
  std::size_t scheduled_data = 0;
  std::size_t scheduled_observables = 0;      ///< [bytes]
  std::vector<std::size_t> scheduled_probes;  ///< [bytes]
  std::size_t scheduled_bodies = 0;
  std::int64_t bodies_step = -1;
};

/// A checkpoint of a simulation, with the state of the outputs of its run.
struct RunCheckpoint : Checkpoint {
  RunCheckpoint() = default;
  RunCheckpoint(Checkpoint simulation) : Checkpoint(std::move(simulation)) {}
  RunRecord run;
};

/// The bytes of a checkpoint file: a block of 512 bytes with the format, the program's version, the
/// size and the SHA-256 of the whole file, then HDF5. Tools such as h5dump skip that block.
std::string encode_checkpoint(const RunCheckpoint& checkpoint);

/// Decodes a checkpoint file. Throws Error (kind run) at `file` if the bytes are not a checkpoint,
/// incomplete, damaged, or of another format version.
RunCheckpoint decode_checkpoint(std::string_view bytes, const std::string& file);
RunCheckpoint read_checkpoint(const std::filesystem::path& file);
/// The checkpoints in a run folder, newest first.
std::vector<std::filesystem::path> checkpoints_of(const std::filesystem::path& folder);

}  // namespace freshet

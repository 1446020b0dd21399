// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/state_array.h"
#include "freshet/report.h"
#include "freshet/scene.h"

namespace freshet {

/// What the observers of a run remember of what they have written.
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

/// What the watch over a run remembers: see sim/health.h.
struct WatchRecord {
  struct Track {
    bool lasting, fatal;
    std::int64_t steps;  ///< over which it was seen
  };
  struct Densest {
    std::uint64_t id;
    std::array<double, 3> x;  ///< [m]
    double value;             ///< [kg/m^D]
  };
  std::vector<Warning> warnings;
  std::vector<Track> tracks;  ///< of each warning
  std::int64_t steps_watched = 0;
  std::int64_t first_step = 0;  ///< of the first look; what it found:
  double first_compression = 0, first_bound = 0;
  Densest first_densest{};
  std::vector<std::int64_t> not_converged;  ///< of each solve, as SolveStatistics counts them
};

/// A moment of a run, from which it goes on to the same bits.
struct Checkpoint {
  struct Array : StateArray {  ///< its `data` is null
    std::vector<std::byte> bytes;
  };
  std::string scene;  ///< TOML, as run; empty for a scene made in code
  std::int64_t steps = 0;
  double time = 0, forces_asked = 0, flows_asked = 0;  ///< [s]
  std::vector<std::int64_t> flowed;                    ///< counts when flows were last asked for
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  bool retries_help = true;  ///< false from a step that halves did not help to one that converges
  std::vector<Array> arrays;
  WatchRecord watch;
  std::string walls_sha256;  ///< over what a restart makes anew from the scene
  RunRecord run;
};

/// The bytes of a checkpoint's file: a block of 512 bytes with the format, the program's version
/// and the SHA-256 of the whole file, then HDF5, which h5dump and the like read past that block.
std::string encode_checkpoint(const Checkpoint& checkpoint);

/// Throws Error (kind run; its place is `file`) if the bytes are no checkpoint, torn, damaged, or
/// of another version's format.
Checkpoint decode_checkpoint(std::string_view bytes, const std::string& file);
Checkpoint read_checkpoint(const std::filesystem::path& file);
/// The checkpoints in the folder of a run, the newest first.
std::vector<std::filesystem::path> checkpoints_of(const std::filesystem::path& folder);

}  // namespace freshet

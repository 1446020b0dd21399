// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "freshet/checkpoint.h"
#include "freshet/run.h"
#include "freshet/simulation.h"
#include "freshet/vector.h"

namespace freshet {

/// A table that grows in the folder of a run. `scheduled` excludes rows that only the end of the
/// run had asked for: a prolonged run has none of them.
struct TableRecord {
  std::string header;  ///< the line of column names
  std::size_t bytes = 0, scheduled = 0;
  std::string sha256, scheduled_sha256;  ///< of so many bytes
  bool operator==(const TableRecord&) const = default;
};

/// A series of numbered files; `scheduled` as in a table.
struct SeriesRecord {
  std::vector<double> times;  ///< [s]
  std::size_t scheduled = 0;
  bool operator==(const SeriesRecord&) const = default;
};

/// The state of the outputs of a run.
struct RunRecord {
  std::string scene_name;                       ///< for report.json
  Simulation::Moment observed{};                ///< when wall_forces and flows were last observed
  double seconds = 0;                           ///< that steps took
  std::vector<Vector> wall_forces;              ///< as last observed
  std::vector<Flow> flows;                      ///< as last observed
  std::map<std::string, TableRecord> tables;    ///< by file name
  std::map<std::string, SeriesRecord> series;   ///< by output
  std::optional<VideoOptions> video;            ///< with an absolute path
  std::map<std::string, std::int64_t> written;  ///< by output: the step after which it last wrote
};

/// A checkpoint of a simulation, with the state of the outputs of its run.
struct RunCheckpoint : Checkpoint {
  RunCheckpoint() = default;
  RunCheckpoint(Checkpoint simulation) : Checkpoint(std::move(simulation)) {}
  RunRecord run;
};

/// Call it at the start of a run: HDF5 takes memory when it is first used.
void prepare_checkpoints();
/// The bytes of a checkpoint file: a block of 512 bytes with the format, the program's version, the
/// size and the SHA-256 of the whole file, then HDF5. Tools such as h5dump skip that block.
std::string encode_checkpoint(const RunCheckpoint& checkpoint);

/// Puts that block before HDF5 data.
std::string sealed_checkpoint(std::string_view hdf5);

/// Decodes a checkpoint file. Throws Error (kind run) at `file` if the bytes are not a checkpoint,
/// incomplete, damaged, of another format version, or hold invalid numbers.
RunCheckpoint decode_checkpoint(std::string_view bytes, const std::string& file);
RunCheckpoint read_checkpoint(const std::filesystem::path& file);
inline constexpr const char* checkpoint_folder = "checkpoints";  // in a run folder
/// The names of the checkpoints in a run folder, complete or not: "step_000000400.h5".
std::set<std::string> checkpoint_names(const std::filesystem::path& folder);
/// The complete checkpoints in a run folder, newest first.
std::vector<std::filesystem::path> checkpoints_of(const std::filesystem::path& folder);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "freshet/scene.h"
#include "io/frame_files.h"

namespace freshet {

/// What the overrides of a finished run's scene may change.
struct ChangeableKeys {
  std::vector<std::string> tables;  ///< such as "picture"
  const char* refusal;              ///< the message about any other key
};
/// The scene of a run with these overrides. Throws Error (kind scene) if the folder holds no run or
/// an override is of another table.
Scene scene_of_run(const std::filesystem::path& folder, const std::vector<Override>& overrides,
                   const ChangeableKeys& keys);

/// The data files of a finished run, and its bodies at their times, by bodies.csv.
class FinishedRun {
 public:
  /// `use` ends "this run wrote no data to USE". Keeps a reference to the scene of the run. Throws
  /// Error (kind scene) if there are no data files, or bodies.csv is missing or damaged.
  FinishedRun(const std::filesystem::path& folder, const Scene& scene, const char* use);

  const std::vector<FrameFile>& files() const { return files_; }
  /// The frame of a file with its bodies. Sets `stored` to the fields that the file has. Throws
  /// Error if the file is damaged or of another dimension, or bodies.csv lacks its time.
  Frame read(const FrameFile& file, DataFields* stored = nullptr) const;

 private:
  void put_bodies(Frame& frame, const std::filesystem::path& file) const;

  const Scene& scene_;
  std::string table_;
  std::vector<FrameFile> files_;
  std::map<double, std::vector<BodyState>> bodies_;  // by time
};

}  // namespace freshet

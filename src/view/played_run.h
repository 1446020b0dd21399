// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include "run/finished_run.h"
#include "view/snapshot.h"

namespace freshet::view {

/// The data files of a finished run, shown one by one.
class PlayedRun {
 public:
  /// Throws Error (kind scene) if the folder holds no run or no data files.
  explicit PlayedRun(const std::filesystem::path& folder);

  bool ended() const { return index_ + 1 >= run_.files().size(); }
  std::size_t index() const { return index_; }
  double time() const { return frame_.time; }
  /// Reads a frame; the last one if there are fewer. Throws Error if its file is damaged.
  void seek(std::size_t index);
  void show(Snapshot& snapshot) const;

 private:
  std::shared_ptr<const Scene> scene_;
  FinishedRun run_;
  std::shared_ptr<const SeriesOverTime> recorded_;
  std::vector<double> times_;
  std::size_t index_ = 0;
  Frame frame_;
};

}  // namespace freshet::view

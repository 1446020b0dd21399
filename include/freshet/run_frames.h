// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

/// The data files of a run folder as frames.
class RunFrames {
 public:
  /// Throws Error (kind scene) if the folder holds no run or no data files, or its bodies.csv is
  /// missing or damaged.
  explicit RunFrames(const std::filesystem::path& run);
  ~RunFrames();
  RunFrames(RunFrames&&) noexcept;
  RunFrames& operator=(RunFrames&&) noexcept;

  const Scene& scene() const;
  std::size_t size() const;
  /// The k-th data file, in the order of their numbers.
  std::filesystem::path file(std::size_t k) const;
  /// The k-th frame with its bodies. Fields that the run did not write are 0, ids count from 0.
  /// Throws Error if the file is damaged or of another dimension, or bodies.csv lacks its time.
  Frame read(std::size_t k) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "freshet/run.h"
#include "freshet/scene.h"

namespace freshet {

struct RenderOptions {
  std::filesystem::path run;        ///< the folder of a run, with its data/
  std::filesystem::path output;     ///< where the pictures go; run/pictures if empty
  bool overwrite = false;           ///< replace pictures that are there
  std::vector<Override> overrides;  ///< of picture.* and camera.*
  int threads = 0;                  ///< 0: as many as the machine has
  std::optional<VideoOptions> video;
  /// Called after every picture with how many there are and how many there will be; false ends it,
  /// with the pictures that are whole.
  std::function<bool(std::size_t done, std::size_t all)> after_picture;
};

struct RenderReport {
  std::vector<std::filesystem::path> pictures;
  bool interrupted = false;
  double seconds = 0;  ///< taken in all
};

/// Draws the frames of a run again, otherwise coloured or seen from elsewhere, without simulating:
/// output/frame_0000.png ..., and a film that shows each frame for the time until the next one.
///
/// Throws Error (kind scene) if the folder holds no run or no data, if an override is of another
/// key, if a picture is there already (unless `overwrite`); Error (kind run) if a file cannot be
/// read or written.
RenderReport render(const RenderOptions& options);

}  // namespace freshet

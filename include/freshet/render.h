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
  std::filesystem::path output;     ///< folder of the pictures; RUN/pictures if empty
  bool overwrite = false;           ///< replace existing pictures
  bool pictures = true;             ///< write them; false: make the video only
  std::vector<Override> overrides;  ///< of picture.* and camera.*
  int threads = 0;                  ///< 0: as many as the machine has
  std::optional<VideoOptions> video;
  /// Called after every picture with the number done and the total. Returning false stops the
  /// rendering; finished pictures stay.
  std::function<bool(std::size_t done, std::size_t all)> after_picture;
  /// Receives a warning before the first picture if data files are missing between others.
  std::function<void(const std::vector<Diagnostic>&)> warn;
};

struct RenderReport {
  std::vector<std::filesystem::path> pictures;
  std::size_t frames = 0;  ///< number of frames drawn
  bool interrupted = false;
  double seconds = 0;  ///< total wall time
};

/// Renders the frames of a run again from its data files, with other colours or another camera.
/// Writes output/frame_0000.png ... and optionally a video that shows each frame until the time of
/// the next one. A picture has the number of its data file. Bodies are drawn from bodies.csv.
///
/// Throws Error (kind scene) if the folder holds no run or no data, an override is neither of
/// picture nor of camera, a picture exists (unless `overwrite`), a data file is damaged or lacks
/// the field of picture.color_by, or bodies.csv is missing, damaged or without the step of a data
/// file. Throws Error (kind run) if a file cannot be written.
RenderReport render(const RenderOptions& options);

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The window of `freshet view`. Another file takes its place where the build has no window.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet::window {

struct Options {
  std::filesystem::path path;  ///< a scene file or the folder of a run; empty: none
  std::filesystem::path log;   ///< actions to repeat, with their scene; replaces `path`
  std::vector<Override> overrides;
  Execution execution;
  bool play = false;
  double pace = 1;                 ///< simulated seconds per second at most; 0: no limit
  int width = 1280, height = 800;  ///< of the window [px]

  std::filesystem::path screenshot;  ///< *.png; draws once without showing a window, and ends
  std::int64_t steps = 0;            ///< taken, or frames gone on, before the first picture
  bool panels = false;               ///< with the panels in the screenshot
  bool water = false;                ///< as a liquid surface, in 3D
  std::string color_by;              ///< a name of picture.color_by; empty: the scene's
  bool measure = false;              ///< waits for each picture, for Result::picture_seconds
  std::int64_t pictures = 0;         ///< closes the window after so many pictures; 0: never
};

/// The state at the end.
struct Result {
  std::string renderer;      ///< of OpenGL
  std::string state_sha256;  ///< empty for a finished run
  std::int64_t steps = 0;
  double time = 0;  ///< [s]
  std::size_t particles = 0;
  std::int64_t pictures = 0;   ///< drawn
  double picture_seconds = 0;  ///< wall time to draw one, the median
  double step_seconds = 0;     ///< wall time of a step, a running mean
};

/// Shows a window until it is closed. Throws Error (kind run) if there is no display or no OpenGL
/// 3.3, and Error (kind scene) with the errors of the scene if it takes a screenshot of one that
/// cannot be opened; a window shows them itself.
Result show(const Options& options);

}  // namespace freshet::window

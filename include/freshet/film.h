// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "freshet/run.h"
#include "freshet/scene.h"

namespace freshet {

struct FilmOptions {
  std::filesystem::path run;        ///< the folder of a run in 3D, with its data/
  std::filesystem::path script;     ///< integrations/blender/render_film.py of this version
  std::filesystem::path output;     ///< folder of the pictures; RUN/film if empty
  bool overwrite = false;           ///< replace existing pictures
  bool keep = false;                ///< keep the folder scene/ beside the pictures
  std::vector<Override> overrides;  ///< of camera.*
  std::optional<double> at;         ///< only the frame nearest to this time [s]
  std::int64_t every = 1;           ///< else the data files whose numbers are multiples of it
  int width = 960, height = 540;    ///< of a picture [px]
  int samples = 32;                 ///< light paths per pixel, at most
  bool denoise = false;             ///< smooth the noise of few samples
  /// Seconds of motion in a picture; 0 for none. Default: a quarter of the time between two
  /// pictures, at most 0.004 s.
  std::optional<double> shutter;
  /// Such as "liquid=milk", "liquid1=oil,ior=1.4" or "rabbit=metal"; docs/film.md lists them.
  std::vector<std::string> materials;
  bool scene_only = false;  ///< write the folder scene/ without pictures and keep it
  int threads = 0;          ///< 0: as many as the machine has
  std::optional<VideoOptions> video;
  /// Called after every picture with the number done and the total. Returning false stops;
  /// finished pictures stay.
  std::function<bool(std::size_t done, std::size_t all)> after_picture;
  /// Called several times a second while Blender works. Returning false ends Blender and the film;
  /// finished pictures stay.
  std::function<bool()> while_rendering;
  /// Receives a warning before the first picture if data files are missing between others.
  std::function<void(const std::vector<Diagnostic>&)> warn;
};

struct FilmReport {
  std::vector<std::filesystem::path> pictures;  ///< with scene_only: frame_0000.json ...
  bool interrupted = false;
  double seconds = 0;  ///< total wall time
};

/// Renders the frames of a run as liquid, by ray tracing: makes the surfaces of each, and has
/// Blender render them in a process of its own. Writes output/frame_0000.png ... and optionally a
/// video that shows each frame until the time of the next one. A picture has the number of its data
/// file.
///
/// The folder output/scene holds what Blender reads: scene.json, frame_0000.json ..., and meshes as
/// *.glb. It is removed at the end unless `keep` or `scene_only` is set. With `scene_only`, Blender
/// is not needed: the add-on in integrations/blender imports the folder.
///
/// Throws Error (kind scene) as make_surfaces and render do, if an option is out of range, if PATH
/// has no program `blender` (unless scene_only), or if no frame is chosen. Throws Error (kind run)
/// with the last lines of its output if Blender fails, and if a file cannot be written.
FilmReport make_film(const FilmOptions& options);

}  // namespace freshet

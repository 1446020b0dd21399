// SPDX-License-Identifier: MIT
/// Surfaces of the frames of a finished run.
#pragma once
#include <filesystem>

#include "freshet/scene.h"
#include "freshet/surface.h"
#include "run/finished_run.h"
#include "surface/fluid_grids.h"

namespace freshet {

/// The scene of a finished run. Throws Error (kind scene) if the folder holds no run, or one in 2D:
/// "this run is in 2D; NOUN needs a run in 3D".
Scene scene_in_3d(const std::filesystem::path& run, const std::vector<Override>& overrides,
                  const ChangeableKeys& keys, const char* noun);

/// The surface of a frame, and its grids. Errors about the frame have `file` as their place.
SurfaceMesh surface_of_frame(const Scene& scene, const Frame& frame,
                             const std::filesystem::path& file, const SurfaceSettings& settings,
                             int threads);
FluidGrids grids_of_frame(const Scene& scene, const Frame& frame, const std::filesystem::path& file,
                          const SurfaceSettings& settings, int threads);

}  // namespace freshet

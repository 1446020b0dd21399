// SPDX-License-Identifier: MIT
/// Fluids that start from another run (Scene::Fluid::from_run).
#pragma once
#include <filesystem>
#include <optional>

#include "freshet/scene.h"

namespace freshet {

/// Sets the shape and the file of a fluid that starts from a run. Leaves the file empty if there is
/// none, which check_run reports.
void find_run_frame(Scene::Fluid& fluid);

/// The data file that a fluid starts from: its from_run, or that file of the run folder whose
/// number or time is asked for, else the last. Throws Error (kind scene) at from_run.
std::filesystem::path run_frame_of(const Scene::Fluid& fluid);

/// What a run's scene.toml says of its particles.
struct RunScene {
  std::filesystem::path file;
  std::optional<double> spacing;
  std::optional<int> dimension;
};
/// The scene of the run that a fluid starts from. Without a scene file in that run, the members are
/// empty.
RunScene run_scene_of(const Scene::Fluid& fluid);

}  // namespace freshet

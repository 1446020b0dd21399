// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>

#include "freshet/simulation.h"

namespace freshet {

/// Writes all that the next steps follow from, whole or not at all (docs/runs.md has the format).
/// Throws Error (kind run) if it cannot be written, or as Simulation::checkpoint does.
void save_checkpoint(const Simulation& simulation, const std::filesystem::path& file);

/// Goes on from such a file, to the same bits, in a simulation made from the same scene.
/// Throws Error (kind run) if the file is no checkpoint, torn, damaged or of another format; (kind
/// scene) if it is of another scene. The simulation is then as it was.
void restore_checkpoint(Simulation& simulation, const std::filesystem::path& file);

/// About how much such a file takes [bytes].
std::size_t checkpoint_bytes(const Simulation& simulation);

}  // namespace freshet

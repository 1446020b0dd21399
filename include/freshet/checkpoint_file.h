// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>

#include "freshet/simulation.h"

namespace freshet {

/// Writes a checkpoint file. A failed write leaves no partial file. docs/runs.md documents the
/// format. Throws Error (kind run) if the write fails or a particle is lost.
void save_checkpoint(const Simulation& simulation, const std::filesystem::path& file);

/// Restores a checkpoint file into a simulation of the same scene, to the same bits.
/// Throws Error (kind run) if the file is not a checkpoint, incomplete, damaged, invalid or of
/// another format version. Throws Error (kind scene) if it is of another scene. The simulation is
/// unchanged after an exception.
void restore_checkpoint(Simulation& simulation, const std::filesystem::path& file);

/// The approximate size of a checkpoint file of this simulation [bytes].
std::size_t checkpoint_bytes(const Simulation& simulation);

}  // namespace freshet

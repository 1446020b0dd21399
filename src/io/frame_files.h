// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "freshet/frame.h"

namespace freshet {

/// The data files of a run's folder in the order of their frames, of the best format that it has:
/// HDF5, else VTP, PLY, CSV. Empty if there are none.
std::vector<std::filesystem::path> frame_files(const std::filesystem::path& run_folder);

/// The frame of a data file. Ids that it lacks count from 0, other fields that it lacks are 0; a
/// file of another program may lack the time and the step as well.
/// Throws Error (kind scene) if it cannot be read, is damaged or of another kind.
Frame read_frame(const std::filesystem::path& file);

/// The same of bytes at hand; `file` tells the format, and stands in messages.
Frame frame_in(std::string_view bytes, const std::filesystem::path& file);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/frame_data.h"

namespace freshet {

/// A data file: data/frame_0007.vtp has the number 7.
struct FrameFile {
  std::filesystem::path path;
  std::int64_t number;
  bool operator==(const FrameFile&) const = default;
};

/// The name of the picture of a data file: "frame_0007.png".
std::string picture_name(const FrameFile& frame);

/// The data files in a run folder in the order of their numbers. The format is the first that
/// exists of HDF5, VTP, PLY and CSV. Empty if there are none.
std::vector<FrameFile> frame_files(const std::filesystem::path& run_folder);

/// Reads a frame from a data file, and its whitewater from the file beside it, if there is one:
/// data/whitewater_0007.*. Missing ids count from 0; other missing fields, the time and the
/// step are 0. Sets `stored` to the fields that the file has. Throws Error (kind scene) if the file
/// cannot be read, is damaged or of an unknown format.
Frame read_frame(const std::filesystem::path& file, DataFields* stored = nullptr);

/// Reads a frame from the bytes of a data file. The extension of `file` selects the format;
/// messages contain `file`. Sets `stored` as read_frame does. Throws Error (kind scene).
Frame frame_in(std::string_view bytes, const std::filesystem::path& file,
               DataFields* stored = nullptr);

}  // namespace freshet

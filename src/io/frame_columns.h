// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "formats/point_formats.h"
#include "io/frame_data.h"

namespace freshet {

/// Reads a frame from the columns of a point file. Missing ids count from 0; other missing fields,
/// the time and the step are 0. Sets `stored` to the fields that the file has. Throws Error (kind
/// scene) at `file`.
Frame decode_columns(std::string_view bytes, const std::string& file, PointReader* read,
                     DataFields& stored);

/// Reads a frame from bytes of encode_csv. Rejects a last line without its end, whose last number
/// may be cut off.
Frame decode_csv(std::string_view bytes, const std::string& file, DataFields& stored);

}  // namespace freshet

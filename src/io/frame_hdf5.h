// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "io/frame_data.h"

namespace freshet {

/// Reads a frame from bytes of encode_hdf5. Missing fields are 0, missing ids count from 0. Throws
/// Error (kind scene) at `place`. Sets `stored` to the fields that the bytes have.
Frame decode_hdf5(std::string_view bytes, const std::string& place, DataFields& stored);

}  // namespace freshet

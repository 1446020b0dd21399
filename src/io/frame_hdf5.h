// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "freshet/frame.h"

namespace freshet {

/// Reads a frame from bytes of encode_hdf5. Missing fields are 0, missing ids count from 0. Throws
/// Error (kind scene) at `place`.
Frame decode_hdf5(std::string_view bytes, const std::string& place);

}  // namespace freshet

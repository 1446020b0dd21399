// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "freshet/frame.h"

namespace freshet {

/// The frame that encode_hdf5 made these bytes of; what is missing is 0, ids count from 0.
/// Throws Error (kind scene) at `place`.
Frame decode_hdf5(std::string_view bytes, const std::string& place);

}  // namespace freshet

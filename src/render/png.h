// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "render/image.h"

namespace freshet {

/// The bytes of a PNG file (8-bit RGB). Throws Error (kind run) if encoding fails.
std::string encode_png(const Image& image);
/// Decodes the bytes of a PNG file. Throws Error (kind run) if they are invalid.
Image decode_png(const std::string& bytes);

}  // namespace freshet

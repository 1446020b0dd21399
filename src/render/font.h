// SPDX-License-Identifier: MIT
#pragma once
#include <cairo/cairo.h>

#include <memory>

namespace freshet {

using Font = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;

/// DejaVu Sans for Cairo, or the font that the system substitutes for it.
/// Throws Error (kind run) if there is no font.
Font load_font(bool bold);

}  // namespace freshet

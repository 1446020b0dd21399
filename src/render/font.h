// SPDX-License-Identifier: MIT
#pragma once
#include <cairo/cairo.h>

#include <memory>

namespace freshet {

using Font = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;

/// DejaVu Sans for Cairo, or what the system has in its place.
/// Throws Error (kind run) where there is no font at all.
Font load_font(bool bold);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::cli {

/// Lets fontconfig find the fonts that came with the program, beside those of the system. For
/// archives on systems without fonts (cmake/package.cmake). FONTCONFIG_FILE, if set, is kept.
void find_own_fonts();

}  // namespace freshet::cli

// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace freshet::cli {

/// Writes a file that appears whole or not at all, and the folders that it is in. Follows no
/// symbolic link at its place. Throws Error (kind run).
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace freshet::cli

// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace freshet {

/// Writes a file: to a temporary file in the same folder, synced, then renamed. Throws Error (kind
/// run) with the path, the system's reason and a remedy; an existing file then stays unchanged.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Renames a finished file and replaces an existing one. Throws Error (kind run) with the path, the
/// system's reason and a remedy.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Throws Error (kind run): `operation` on `path` failed for `reason`, a value of errno.
[[noreturn]] void fail_file(const std::filesystem::path& path, const std::string& operation,
                            int reason);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace freshet {

/// Writes a file: to a temporary file in the same folder, synced, then renamed. Throws Error (kind
/// run) with the path, the system's reason and a remedy; an existing file then stays unchanged.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Writes `bytes` at the end of a file that has `size` bytes by now, and syncs it. What stands
/// behind these, a row that a killed run left, is cut off. A file of size 0 is made anew. Throws
/// Error (kind run); the file then has its `size` bytes, unless another program cut it.
void append_file(const std::filesystem::path& file, std::size_t size, std::string_view bytes);

/// Puts a finished file in the place of another, or throws as write_file does.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Throws Error (kind run): `operation` on `path` failed for `reason`, a value of errno.
[[noreturn]] void fail_file(const std::filesystem::path& path, const std::string& operation,
                            int reason);

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The folder of a run that is started without --output.
#pragma once
#include <filesystem>
#include <string>

namespace freshet::cli {

/// Whether the folder holds a run, finished or not.
bool holds_run(const std::filesystem::path& folder);
/// The first of FOLDER-2, FOLDER-3, ... that does not exist.
std::filesystem::path next_free(const std::filesystem::path& folder);

/// Whether somebody can be asked: standard input and standard error are a terminal.
bool is_terminal();
/// Prints the question on standard error and reads one line. True if it begins with y.
bool ask(const std::string& question);

}  // namespace freshet::cli

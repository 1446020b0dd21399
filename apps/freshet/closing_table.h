// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "freshet/report.h"
#include "freshet/scene.h"

namespace freshet::cli {

/// The results of a run in the folder `output`, one per line: what the scene has, with its checks
/// beside their values.
std::string closing_table(const Scene& scene, const Report& report,
                          const std::filesystem::path& output);

}  // namespace freshet::cli

// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/error.h"
#include "io/frame_files.h"

namespace freshet {

/// A warning that names the data files that are missing among the numbers from, from + every, ...
/// up to the last of `frames`, and what that means; nothing if none is missing.
std::vector<Diagnostic> gaps_in(const std::vector<FrameFile>& frames,
                                const std::string& consequence, std::int64_t from = 0,
                                std::int64_t every = 1);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// Warnings about the probes of a valid scene with its defaults filled in.
std::vector<Diagnostic> probe_warnings(const Scene& scene);

}  // namespace freshet

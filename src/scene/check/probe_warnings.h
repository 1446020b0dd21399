// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// What is doubtful about the probes of a good scene with its defaults filled in.
std::vector<Diagnostic> probe_warnings(const Scene& scene);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/derived.h"

namespace freshet {

/// What is doubtful about the bodies of a good scene with its defaults filled in.
std::vector<Diagnostic> body_warnings(const Scene& scene, const Derived& derived);

}  // namespace freshet

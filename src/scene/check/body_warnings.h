// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/derived.h"

namespace freshet {

/// Warnings about the bodies of a valid scene with its defaults filled in.
std::vector<Diagnostic> body_warnings(const Scene& scene, const Derived& derived);

/// Warnings about walls and bodies that do not separate the fluids on their two sides.
std::vector<Diagnostic> thin_wall_warnings(const Scene& scene, const Derived& derived);

}  // namespace freshet

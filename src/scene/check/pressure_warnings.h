// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/derived.h"
#include "freshet/error.h"

namespace freshet {

/// Warnings of what the pressure may not hold: flows near the speed of sound, liquids of very
/// different density, deep still water.
std::vector<Diagnostic> pressure_warnings(const Scene& scene, const Derived& derived);

}  // namespace freshet

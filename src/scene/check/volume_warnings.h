// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/derived.h"
#include "freshet/scene.h"

namespace freshet {

/// Warnings about fluids whose particles have another volume than their shape. `scene` has its
/// defaults filled in.
std::vector<Diagnostic> volume_warnings(const Scene& scene, const Derived& derived);

}  // namespace freshet

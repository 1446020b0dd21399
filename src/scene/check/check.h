// SPDX-License-Identifier: MIT
#pragma once
#include <set>

#include "freshet/scene.h"

namespace freshet {

/// What the keys say together: throws Error (kind scene) with everything that contradicts itself,
/// is missing or is used by nothing.
void check_scene(const Scene& scene);

/// The same as a list. What depends on a section in `unread`, which holds keys that could not be
/// read, is left out.
std::vector<Diagnostic> contradictions(const Scene& scene,
                                       const std::set<std::string, std::less<>>& unread);

}  // namespace freshet

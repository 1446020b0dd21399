// SPDX-License-Identifier: MIT
#pragma once
#include <set>

#include "freshet/scene.h"

namespace freshet {

/// Checks the keys against each other. Throws Error (kind scene) with all contradictions, missing
/// keys and unused keys.
void check_scene(const Scene& scene);

/// All contradictions, missing keys and unused keys of a scene. Checks that depend on a section of
/// `unread`, which has missing or invalid keys, are skipped.
std::vector<Diagnostic> contradictions(const Scene& scene,
                                       const std::set<std::string, std::less<>>& unread);

}  // namespace freshet

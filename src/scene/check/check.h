// SPDX-License-Identifier: MIT
#pragma once
#include <set>

#include "freshet/scene.h"

namespace freshet {

/// Checks the keys against each other. Throws Error (kind scene) with all contradictions, missing
/// keys and unused keys.
void check_scene(const Scene& scene);

/// A key that is set although nothing reads it, or although the solver does not support its value.
struct UnusedKey {
  std::string key;
  Diagnostic why;  ///< an error; its remedy comes after the last "; "
};
std::vector<UnusedKey> unused_keys(const Scene& scene,
                                   const std::set<std::string, std::less<>>& unread);

/// All contradictions, missing keys and unused keys of a scene. Checks that depend on a section of
/// `unread`, which has missing or invalid keys, are skipped.
std::vector<Diagnostic> contradictions(const Scene& scene,
                                       const std::set<std::string, std::less<>>& unread);

}  // namespace freshet

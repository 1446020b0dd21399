// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// The scene of a run with the probes and counters of TOML text in place of its own. The text has
/// the tables [[probe]] and [[counter]] of a scene, and no others; or it is a scene, of which the
/// other tables are skipped. Messages use `name` as the file
/// name. Throws Error (kind scene) with every semantic error at once, or one syntax error alone.
Scene measured_scene(const Scene& run, const std::string& text, const std::string& name,
                     const std::vector<Override>& overrides = {});

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <toml++/toml.h>

#include "freshet/scene.h"

namespace freshet {

/// Puts `KEY=VALUE` pairs into the table. VALUE is read as TOML, and taken as a string if that
/// fails. KEY may have an index into an array of tables: fluid[1].velocity. Without an index the
/// array must have one table. Without VALUE, the key or table is removed. Returns where each value
/// came from: "fluid[0].count" -> "override fluid.count". Throws Error (kind scene) for an invalid
/// key, or one to remove that is missing.
std::map<std::string, std::string> apply_overrides(toml::table& root,
                                                   const std::vector<Override>& overrides);

}  // namespace freshet

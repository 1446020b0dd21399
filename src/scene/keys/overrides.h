// SPDX-License-Identifier: MIT
#pragma once
#include <toml++/toml.h>

#include "freshet/scene.h"

namespace freshet {

/// Puts `KEY=VALUE` pairs into the table: VALUE is TOML, else a string. KEY may count the tables of
/// an array: fluid[1].velocity; without a count it means the only one.
/// Returns where they went: "fluid[0].count" -> "--set fluid.count". Throws Error (kind scene).
std::map<std::string, std::string> apply_overrides(toml::table& root,
                                                   const std::vector<Override>& overrides);

}  // namespace freshet

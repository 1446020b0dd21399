// SPDX-License-Identifier: MIT
#pragma once
#include <toml++/toml.h>

#include <string>

namespace freshet {

/// Parses TOML. Throws Error (kind scene) at `name`:LINE:COLUMN for a syntax error.
toml::table parse_toml(const std::string& text, const std::string& name);

}  // namespace freshet

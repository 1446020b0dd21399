// SPDX-License-Identifier: MIT
#pragma once
#include <toml++/toml.h>

#include <string>

namespace freshet {

/// Parses TOML. Throws Error (kind scene) at `name`:LINE:COLUMN for a syntax error, and for keys or
/// brackets so deep that the parser would overflow the stack. `noun`: what the file should be.
toml::table parse_toml(const std::string& text, const std::string& name,
                       const char* noun = "scene file");

}  // namespace freshet

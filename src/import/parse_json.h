// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace freshet {

/// The object of a JSON scene. Throws Error (kind scene) at FILE:LINE:COLUMN.
nlohmann::json parse_json(const std::string& json, const std::string& file);

}  // namespace freshet

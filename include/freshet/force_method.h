// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <vector>

namespace freshet {

/// What a force beside pressure says of itself: one choice of a key such as
/// solver.viscosity_method. Checks and the table of keys read this. src/forces has the force.
struct ForceMethod {
  std::string_view key;  ///< the key that chooses it
  const char* name;      ///< in scenes
  const char* paper;     ///< authors and year; "" for none
  /// The scene keys that it reads and another choice does not.
  std::vector<std::string_view> reads = {};
};

/// All forces, those of one key in the order of its enum.
const std::vector<ForceMethod>& force_methods();

}  // namespace freshet

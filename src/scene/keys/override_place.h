// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// The place of a diagnostic about an override.
inline std::string place_of(const Override& change) {
  return (change.second ? "override " : "removal ") + change.first;
}

}  // namespace freshet

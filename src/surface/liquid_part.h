// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/frame.h"

namespace freshet {

/// The particles of one liquid: ids, positions and velocities. A frame of one liquid is that of
/// liquid 0.
Frame liquid_part(const Frame& frame, int liquid);

}  // namespace freshet

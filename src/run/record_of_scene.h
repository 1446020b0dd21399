// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"
#include "io/checkpoint.h"

namespace freshet {

/// Checks that the record in a checkpoint has the walls and flows of the scene, or none yet. Throws
/// Error (kind run) without a place.
void check_record_of_scene(const RunRecord& record, const Scene& scene);

}  // namespace freshet

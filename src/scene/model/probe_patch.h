// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/particles.h"
#include "freshet/scene.h"

namespace freshet {

/// The piece of wall of a probe of kind `wall`: in 2D the segment from `from` to `to`; in 3D the
/// rectangle with these opposite corners. Its edges are parallel to the axes, or one is parallel to
/// `along`.
WallPatch patch_of(const Scene::Probe& probe);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// The volume [m^D] of a fluid's shape inside the domain, without walls and bodies. It is computed
/// from the surfaces, not from the fluid's lattice. Places that sheets, walls of points and inlets
/// exclude are not asked for. Not for points. The scene must have its
/// defaults filled in.
double volume_asked(const Scene& scene, const Scene::Fluid& fluid);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "mesh/triangle_mesh.h"
#include "render/image.h"

namespace freshet {

/// The colour of a body: wood for free bodies, iron for others.
inline Color body_color(const Scene& scene, std::size_t k) {
  return scene.body[k].motion == BodyMotion::free ? Color{214, 158, 96} : Color{150, 154, 166};
}

/// The surfaces of a 3D scene's bodies, placed by their states in a frame.
std::vector<TriangleMesh> posed_bodies(const Scene& scene, const Frame& frame);

}  // namespace freshet

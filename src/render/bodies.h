// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "mesh/triangle_mesh.h"
#include "render/image.h"

namespace freshet {

/// Free bodies are of wood, others of iron.
inline Color body_color(const Scene& scene, std::size_t k) {
  return scene.body[k].motion == BodyMotion::free ? Color{214, 158, 96} : Color{150, 154, 166};
}

/// The surfaces of a scene's bodies in 3D where a frame has them.
std::vector<TriangleMesh> posed_bodies(const Scene& scene, const Frame& frame);

}  // namespace freshet

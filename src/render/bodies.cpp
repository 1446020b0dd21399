// SPDX-License-Identifier: MIT
#include "render/bodies.h"

#include <algorithm>

#include "core/rotation.h"
#include "scene/model/body_mesh.h"
#include "scene/model/body_shape.h"

namespace freshet {

std::vector<TriangleMesh> posed_bodies(const Scene& s, const Frame& frame) {
  std::vector<TriangleMesh> all;
  for (std::size_t k = 0; k < std::min(s.body.size(), frame.bodies.size()); ++k) {
    all.push_back(body_mesh(s.body[k]));
    const auto center = body_shape(s.body[k]).center;
    const BodyState& now = frame.bodies[k];
    const Rotation turn(now.orientation);
    for (auto& x : all.back().points)
      x = TriangleMesh::Point{now.position[0], now.position[1], now.position[2]} + turn(x - center);
  }
  return all;
}

}  // namespace freshet

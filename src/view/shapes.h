// SPDX-License-Identifier: MIT
/// The surroundings of the fluid as triangles and lines: sides of the domain, walls, bodies,
/// probes.
#pragma once
#include <vector>

#include "freshet/frame.h"
#include "mesh/triangle_mesh.h"
#include "view/camera.h"

namespace freshet::view {

struct Tint {
  float r, g, b, a;
};

/// Triangles, lines and points that move together.
struct Part {
  enum class Kind { domain, wall, body, probe };
  Kind kind = Kind::domain;
  std::vector<float> triangles;  ///< position and normal of each corner: six numbers
  std::vector<float> lines;      ///< positions of both ends: three numbers each
  std::vector<float> points;     ///< position and 0: four numbers each
  Tint fill{}, edge{};
  int body = -1;  ///< index of the body that carries it; -1: it is at rest
  Point start{};  ///< the body's centre of mass at the start
};

/// The parts of a scene that has its defaults.
std::vector<Part> parts_of(const Scene& scene);
/// The placement of a part that starts at `start`.
Matrix placement_of(const Part& part, const Frame& frame);

/// The triangles of a simple polygon, its corners counterclockwise: three indices each.
std::vector<TriangleMesh::Triangle> triangulate(const std::vector<Vec<2, double>>& corners);

}  // namespace freshet::view

// SPDX-License-Identifier: MIT
#include "core/vec.h"
#include "freshet/surface.h"

namespace freshet {
namespace {

using Point = Vec<3, double>;

/// The corners of a triangle relative to a point of the mesh, for accuracy far from the origin.
std::array<Point, 3> corners(const SurfaceMesh& mesh, std::size_t triangle) {
  std::array<Point, 3> all;
  const SurfaceMesh::Point& from = mesh.position.front();
  for (std::size_t c = 0; c < 3; ++c) {
    const SurfaceMesh::Point& p = mesh.position[mesh.triangles[triangle][c]];
    all[c] = {double(p[0]) - double(from[0]), double(p[1]) - double(from[1]),
              double(p[2]) - double(from[2])};
  }
  return all;
}

}  // namespace

double volume_of(const SurfaceMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners(mesh, t);
    sum += dot(a, cross(b, c));
  }
  return sum / 6;
}

double area_of(const SurfaceMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners(mesh, t);
    sum += norm(cross(b - a, c - a));
  }
  return sum / 2;
}

}  // namespace freshet

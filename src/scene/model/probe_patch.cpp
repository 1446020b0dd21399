// SPDX-License-Identifier: MIT
#include "scene/model/probe_patch.h"

#include <cmath>

#include "core/in_3d.h"

namespace freshet {
namespace {

using Vec3 = Vec<3, double>;

std::size_t axes_between(const Vector& from, const Vector& to) {
  std::size_t axes = 0;
  for (std::size_t d = 0; d < from.size(); ++d) axes += from[d] != to[d];
  return axes;
}

WallPatch along_the_axes(const Scene::Probe& p) {
  const std::size_t n = p.from.size();
  WallPatch patch{p.from, p.from, std::vector<Vector>(n, Vector(n, 0.0))};
  for (std::size_t d = 0; d < n; ++d) {
    patch.center[d] = (p.from[d] + p.to[d]) / 2;
    patch.half[d] = std::abs(p.to[d] - p.from[d]) / 2;
    patch.axes[d][d] = 1;
  }
  return patch;
}

}  // namespace

WallPatch patch_of(const Scene::Probe& p) {
  const std::size_t n = p.from.size();
  if (p.along.empty() && (n == 3 || axes_between(p.from, p.to) == 1)) return along_the_axes(p);
  const Vec3 diagonal = in_3d(p.to) - in_3d(p.from);
  const Vec3 direction = p.along.empty() ? diagonal : in_3d(p.along);
  const Vec3 u = (1 / norm(direction)) * direction;
  const double length = dot(diagonal, u);
  WallPatch patch = along_the_axes(p);
  if (n == 2) {
    patch.axes = {in_scene(u, n), in_scene({-u.y, u.x, 0}, n)};
    patch.half = {length / 2, 0};
    return patch;
  }
  const Vec3 across = diagonal - length * u;
  const Vec3 w = (1 / norm(across)) * across;
  patch.axes = {in_scene(u, n), in_scene(w, n), in_scene(cross(u, w), n)};
  patch.half = {std::abs(length) / 2, norm(across) / 2, 0};
  return patch;
}

}  // namespace freshet

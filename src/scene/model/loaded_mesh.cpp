// SPDX-License-Identifier: MIT
#include "scene/model/loaded_mesh.h"

#include <algorithm>

#include "scene/model/region_rotation.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;

MeshSource source_of(const Scene::Region& r, double fill_below) {
  return {r.shape, r.file, r.points,   r.base,        r.scale,
          r.min,   r.max,  r.rotation, r.translation, fill_below};
}

TriangleMesh mesh_of_file(const Scene::Region& r) {
  TriangleMesh mesh = read_mesh(r.file);
  const RegionRotation turned(r.rotation);
  const Point translation = r.translation.empty() ? Point{} : vec_of<3>(r.translation);
  for (Point& x : mesh.points) x = turned(r.scale * x) + translation;
  return mesh;
}

TriangleMesh triangles_of_turned_box(const Scene::Region& r) {
  const auto box = solid_of<3>(r);
  const RegionRotation turned(r.rotation);
  TriangleMesh mesh = triangles_of_box(box.center - box.half, box.center + box.half);
  for (Point& x : mesh.points) x = box.center + turned(x - box.center);
  return mesh;
}

/// Whether the vectors of a region have the sizes that loading needs.
bool has_sizes(const Scene::Region& r, std::size_t n) {
  const std::size_t angles = n == 2 ? 1 : 3;
  if (!r.rotation.empty() && r.rotation.size() != angles) return false;
  if (!r.translation.empty() && r.translation.size() != n) return false;
  if (r.shape == Shape::mesh) return n == 3 && !r.file.empty();
  if (r.shape == Shape::polygon)
    return n == 2 && r.points.empty() != r.file.empty() &&
           std::all_of(r.points.begin(), r.points.end(),
                       [](const Vector& p) { return p.size() == 2; });
  return r.min.size() == n && r.max.size() == n;
}

}  // namespace

std::shared_ptr<const LoadedMesh> load_mesh(const Scene::Region& r, double fill_below) {
  Outline outline;
  TriangleMesh mesh;
  MeshCondition condition;
  if (r.shape == Shape::mesh) {
    mesh = mesh_of_file(r);
    condition = mend_mesh(mesh, fill_below);
    if (mesh.triangles.empty())
      throw Error(Error::Kind::scene, r.file,
                  "every triangle in it is degenerate: two of its corners coincide; export the "
                  "mesh again");
  } else if (r.shape == Shape::box && r.min.size() == 3) {
    mesh = triangles_of_turned_box(r);
  } else {
    outline = outline_of(r);
    require_valid(outline, r);
    mesh = prism_of(outline);
  }
  return std::make_shared<LoadedMesh>(LoadedMesh{
      source_of(r, fill_below), condition, MeshDistance(std::move(mesh)), std::move(outline)});
}

void remember_mesh(Scene::Region& r, std::size_t dimension, double fill_below) {
  if (!is_mesh(r) || !has_sizes(r, dimension)) return;
  if (r.loaded && r.loaded->source == source_of(r, fill_below)) return;
  r.loaded = nullptr;
  try {
    r.loaded = load_mesh(r, fill_below);
  } catch (const Error&) {
  }
}

Vec<3, double> sides_of(const LoadedMesh& mesh) {
  Vec<3, double> sides = mesh.distance.high() - mesh.distance.low();
  if (!mesh.outline.empty()) sides.z = 0;
  return sides;
}

}  // namespace freshet

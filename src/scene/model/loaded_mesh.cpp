// SPDX-License-Identifier: MIT
#include "scene/model/loaded_mesh.h"

#include <cmath>
#include <numbers>

#include "scene/model/solid_of.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;

/// A rotation about x, then y, then z.
class Rotation {
 public:
  explicit Rotation(const Vector& degrees) {
    for (std::size_t k = 0; k < degrees.size(); ++k) {
      const double angle = degrees[k] * std::numbers::pi / 180;
      cos_[k] = std::cos(angle);
      sin_[k] = std::sin(angle);
    }
  }
  Point operator()(Point p) const {
    p = {p.x, cos_[0] * p.y - sin_[0] * p.z, sin_[0] * p.y + cos_[0] * p.z};
    p = {cos_[1] * p.x + sin_[1] * p.z, p.y, cos_[1] * p.z - sin_[1] * p.x};
    return {cos_[2] * p.x - sin_[2] * p.y, sin_[2] * p.x + cos_[2] * p.y, p.z};
  }

 private:
  double cos_[3] = {1, 1, 1}, sin_[3] = {0, 0, 0};
};

}  // namespace

std::shared_ptr<const LoadedMesh> load_mesh(const Scene::Region& r, double fill_below) {
  TriangleMesh mesh = read_mesh(r.file);
  const Rotation turned(r.rotation);
  const Point translation = r.translation.empty() ? Point{} : vec_of<3>(r.translation);
  for (Point& x : mesh.points) x = turned(r.scale * x) + translation;
  const MeshCondition condition = mend_mesh(mesh, fill_below);
  if (mesh.triangles.empty())
    throw Error(
        Error::Kind::scene, r.file,
        "every triangle in it is degenerate: two of its corners coincide; export the mesh again");
  return std::make_shared<LoadedMesh>(LoadedMesh{r.file, r.scale, r.rotation, r.translation,
                                                 fill_below, condition,
                                                 MeshDistance(std::move(mesh))});
}

void remember_mesh(Scene::Region& r, double fill_below) {
  if (r.shape != Shape::mesh || r.file.empty()) return;
  for (const Vector* v : {&r.rotation, &r.translation})
    if (!v->empty() && v->size() != 3) return;
  const LoadedMesh* is = r.loaded.get();
  if (is && is->file == r.file && is->scale == r.scale && is->rotation == r.rotation &&
      is->translation == r.translation && is->fill_below == fill_below)
    return;
  r.loaded = nullptr;
  try {
    r.loaded = load_mesh(r, fill_below);
  } catch (const Error&) {
  }
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/sample/faces.h"

#include <limits>

#include "scene/model/region_rotation.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

template <int D> Solid<D, double> plane(Vec<D, double> at, Vec<D, double> normal) {
  Solid<D, double> solid;
  solid.kind = SolidKind::plane;
  solid.center = at;
  solid.axis = normal;
  return solid;
}

template <int D> class FaceList {
 public:
  std::vector<Face<D>> all;

  void region(const Scene::Region& r, bool of_wall,
              const std::vector<Vec<D, double>>& shifts = {{}}) {
    for (const auto& shift : shifts)
      for (const auto& surface : surfaces(r)) all.emplace_back(surface, shift, of_wall);
  }
  /// The lower or upper end of axis k.
  void end(int k, bool lower, double at, bool of_wall) {
    Vec<D, double> x{}, normal{};
    component(x, k) = at;
    component(normal, k) = lower ? 1 : -1;
    all.emplace_back(RegionSurface<D>(plane<D>(x, normal)), Vec<D, double>{}, of_wall);
  }

 private:
  static std::vector<RegionSurface<D>> surfaces(const Scene::Region& r) {
    if (r.side == Side::outside || (r.shape != Shape::box && r.shape != Shape::cylinder)) {
      const RegionSurface<D> whole(r, 0);
      if (whole.is_sheet()) return {};
      return {whole};
    }
    auto solid = solid_of<D>(r);
    std::vector<RegionSurface<D>> parts;
    const auto ends = [&](Vec<D, double> axis, double half) {
      for (const double sign : {-1.0, 1.0})
        parts.emplace_back(plane<D>(solid.center + sign * half * axis, -sign * axis));
    };
    if (r.shape == Shape::cylinder) {
      ends(solid.axis, solid.half_length);
      solid.half_length = std::numeric_limits<double>::infinity();
      parts.emplace_back(solid);
      return parts;
    }
    for (int k = 0; k < D; ++k) {
      Vec<D, double> axis{};
      component(axis, k) = 1;
      if (is_turned_box(r)) axis = RegionRotation(r.rotation)(axis);
      ends(axis, component(solid.half, k));
    }
    return parts;
  }
};

}  // namespace

template <int D> std::vector<Face<D>> faces_around(const Scene& s, const Scene::Fluid& f) {
  FaceList<D> faces;
  for (int side = 0; side < 2 * D; ++side)
    if (keeps_distance(s, f, side)) {
      const auto& ends = side % 2 ? s.domain.max : s.domain.min;
      faces.end(side / 2, side % 2 == 0, ends[std::size_t(side / 2)], true);
    }
  const auto shifts = periodic_shifts<D>(s);
  for (const Scene::Wall& w : s.wall)
    if (w.shape != Shape::points) faces.region(w, true, shifts);
  for (const Scene::Body& b : s.body) faces.region(b, true, shifts);
  if (!f.surface.empty())
    faces.all.emplace_back(RegionSurface<D>(FreeSurface(f.surface, D, s.particles.spacing)),
                           Vec<D, double>{}, true);
  if (!is_block(f)) {
    faces.region(f, false);
    return std::move(faces.all);
  }
  const double half = s.particles.spacing / 2;
  const Lattice lattice = lattice_of(s, f);
  const Vector last = lattice.last(s.particles.spacing);
  for (int k = 0; k < D; ++k) {
    faces.end(k, true, lattice.from[std::size_t(k)] - half, false);
    faces.end(k, false, last[std::size_t(k)] + half, false);
  }
  return std::move(faces.all);
}

template std::vector<Face<2>> faces_around<2>(const Scene&, const Scene::Fluid&);
template std::vector<Face<3>> faces_around<3>(const Scene&, const Scene::Fluid&);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "boundary/solid.h"
#include "freshet/scene.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class R = double> Vec<D, R> vec_of(const Vector& a) {
  Vec<D, R> v{};
  for (int k = 0; k < D; ++k) component(v, k) = R(a[std::size_t(k)]);
  return v;
}

/// The unit vector along `a`, which must not be 0.
template <int D> Vec<D, double> unit_of(const Vector& a) {
  const auto v = vec_of<D>(a);
  double most = 0;  // divided out first: squares of tiny numbers underflow
  for (const double x : a) most = std::max(most, std::abs(x));
  return v / most / norm(v / most);
}

/// Whether a region is a box that is not parallel to the axes.
inline bool is_turned_box(const Scene::Region& r) {
  return r.shape == Shape::box && std::any_of(r.rotation.begin(), r.rotation.end(),
                                              [](double degrees) { return degrees != 0; });
}
/// Whether the surface of a region is Region::loaded: triangles of a file, the outline of a polygon
/// or a turned box.
inline bool is_mesh(const Scene::Region& r) {
  return r.shape == Shape::mesh || r.shape == Shape::polygon || is_turned_box(r);
}
/// Whether the surface of a region has a formula.
inline bool is_solid(const Scene::Region& r) { return r.shape != Shape::points && !is_mesh(r); }

/// The surface of a box, sphere, cylinder or plane of a scene with its defaults filled in. A box is
/// not turned.
template <int D, class R = double> Solid<D, R> solid_of(const Scene::Region& r) {
  Solid<D, R> solid;
  solid.fluid_inside = r.side == Side::inside;
  switch (r.shape) {
    case Shape::sphere:
      solid.kind = SolidKind::ball;
      solid.center = vec_of<D, R>(r.center);
      solid.radius = R(r.radius);
      break;
    case Shape::cylinder:
      solid.kind = SolidKind::cylinder;
      solid.center = vec_of<D, R>(r.center);
      solid.radius = R(r.radius);
      solid.half_length = R(r.length / 2);
      break;
    case Shape::plane:
      solid.kind = SolidKind::plane;
      solid.center = vec_of<D, R>(r.point);
      break;
    case Shape::box:
    case Shape::lattice:
    case Shape::points:
    case Shape::mesh:
    case Shape::polygon:
      for (int k = 0; k < D; ++k) {
        const double low = r.min[std::size_t(k)], high = r.max[std::size_t(k)];
        component(solid.center, k) = R((low + high) / 2);
        component(solid.half, k) = R((high - low) / 2);
      }
  }
  if (r.shape == Shape::plane || r.shape == Shape::cylinder) {
    auto axis = unit_of<D>(r.shape == Shape::plane ? r.normal : r.axis);
    for (int k = 0; k < D; ++k) component(solid.axis, k) = R(component(axis, k));
  }
  return solid;
}

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

#include "scene/model/setup.h"
#include "scene/model/solid_of.h"
#include "scene/sample/region_surface.h"

namespace freshet {

/// Half the thickness of a shape behind its surface [m].
template <int D> double half_thickness(const Solid<D, double>& solid) {
  if (solid.fluid_inside || solid.kind == SolidKind::plane)
    return std::numeric_limits<double>::infinity();
  if (solid.kind == SolidKind::ball) return solid.radius;
  if (solid.kind == SolidKind::cylinder) return std::min(solid.radius, solid.half_length);
  Vec<D, double> half = solid.half;
  double least = half.x;
  for (int k = 1; k < D; ++k) least = std::min(least, component(half, k));
  return least;
}

/// The depth and the volumes of the boundary particles of akinci2012. A layer in the middle of a
/// thin wall is closer to the fluid than the layer of a thick wall; its particles have smaller
/// volumes, so that the fluid has its rest density on either side.
class AkinciLayer {
 public:
  explicit AkinciLayer(const Scene& s)
      : scene_(s), spacing_(s.particles.spacing), setback_(single_layer_distance(s) - spacing_) {}

  /// Behind the surface of a thick wall [m].
  double depth() const { return spacing_ / 2 + setback_; }
  /// Of that layer behind one of half a spacing [m].
  double setback() const { return setback_; }
  /// Moves a point about half a spacing behind the surface to the depth of the layer, but not past
  /// the middle of the solid.
  template <int D> void settle(const Solid<D, double>& solid, Vec<D, double>& x) const {
    const double room = half_thickness(solid) + solid.distance(x);
    x += -std::min(setback_, std::max(0.0, room)) * solid.normal(x);
  }
  /// Of a particle of a region. All particles of a box, ball or cylinder have the factor of its
  /// thickness, those of a mesh or polygon that of their depth.
  template <int D>
  Real volume_factor(const Scene::Region& region, const RegionSurface<D>& surface,
                     Vec<D, double> x) const {
    const bool varies = region.shape == Shape::mesh || region.shape == Shape::polygon;
    const double most = varies ? -surface.distance(x) : half_thickness(solid_of<D>(region));
    return most > same * depth() ? 1 : Real(single_layer_volume(scene_, spacing_ / 2 + most));
  }

 private:
  static constexpr double same = 0.949;  // fraction: mesh particles may be 5 % less deep

  const Scene& scene_;
  double spacing_, setback_;
};

}  // namespace freshet

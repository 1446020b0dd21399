// SPDX-License-Identifier: MIT
#pragma once
#include "scene/sample/region_surface.h"

namespace freshet {

/// A smooth surface that bounds a fluid: a side of the domain, a face of a wall or body, the free
/// surface, or a face of the fluid's own shape.
template <int D> class Face {
 public:
  Face(RegionSurface<D> surface, Vec<D, double> shift, bool of_wall)
      : surface_(std::move(surface)), shift_(shift), of_wall_(of_wall) {}

  /// Whether it is a wall's, a side's or the free surface, rather than the shape's.
  bool of_wall() const { return of_wall_; }
  bool is_free() const { return surface_.is_free(); }
  /// The distance of x [m], positive on the fluid's side.
  double distance(Vec<D, double> x) const { return surface_.distance(x + shift_); }
  /// The unit normal at the nearest point; it points towards the fluid.
  Vec<D, double> normal(Vec<D, double> x) const { return surface_.normal(x + shift_); }

 private:
  RegionSurface<D> surface_;
  Vec<D, double> shift_;  ///< a wall acts across periodic ends
  bool of_wall_;
};

/// The faces that bound a fluid, which has a lattice. A shape around the fluid is divided into
/// faces, so that a corner has several. Sheets, walls of points and inlets have no faces.
template <int D> std::vector<Face<D>> faces_around(const Scene& scene, const Scene::Fluid& fluid);

}  // namespace freshet

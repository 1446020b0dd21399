// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "core/surface_points.h"
#include "freshet/simulation.h"

namespace freshet {

/// The load of the fluid on the surfaces of walls and bodies, at the boundary particles next to the
/// fluid, projected onto the surface. A point of a wall of several layers carries the load of the
/// boundary particles behind it. All boundary particles of a wall count, as for a probe of kind
/// "wall".
class Surfaces {
 public:
  /// Keeps a reference to the scene, which must have its defaults filled in.
  explicit Surfaces(const Scene& scene);
  ~Surfaces();
  SurfacePoints load(const BoundaryForces& boundary, const std::vector<BodyState>& bodies) const;

  struct Geometry;

 private:
  std::unique_ptr<Geometry> geometry_;
};

/// The force on each part, that is each of Scene::wall_names(), then each of Scene::body
/// [N; N/m in 2D].
std::vector<Vector> forces_on_parts(const Scene& scene, const BoundaryForces& boundary);

}  // namespace freshet

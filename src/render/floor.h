// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "boundary/solid.h"
#include "freshet/frame.h"
#include "mesh/triangle_mesh.h"
#include "render/camera.h"

namespace freshet {

/// The unit vector towards the light.
inline Point light_direction() {
  const Point l{-0.45, 1, 0.4};
  return l / norm(l);
}

/// The bounding box. The solid must not be a plane.
Bounds bounds_of(const Solid<3, double>& solid);

/// The shadows of the fluid and of solids on the bottom of the domain, with soft edges.
class FloorShadow {
 public:
  /// fluid_opacity: optical depth of one layer of particles.
  FloorShadow(const Scene& scene, const Frame& fluid, const std::vector<Solid<3, double>>& solids,
              const std::vector<TriangleMesh>& bodies, float fluid_opacity);

  /// The shadow at (x, z) on the floor [m]: 0 in full light, 1 in full shadow.
  float operator()(double x, double z) const;

 private:
  void add_fluid(const Scene& scene, const Frame& fluid);
  void add_solid(const Solid<3, double>& solid);
  void add_mesh(const TriangleMesh& mesh);
  void blur(int radius);
  float& cell(int i, int j) { return dark_[std::size_t(j) * std::size_t(nx_) + std::size_t(i)]; }

  Point low_, high_;
  double side_;  // side of a cell [m]
  int nx_, nz_;
  std::vector<float> dark_;
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include "scene/model/loaded_mesh.h"
#include "scene/model/solid_of.h"

namespace freshet {

/// The surface of a region, except of points, of a scene with its defaults filled in. An open mesh
/// is a sheet as thick as one spacing.
template <int D> class RegionSurface {
 public:
  RegionSurface(const Scene::Region& region, double spacing) : sheet_(spacing) {
    if (is_solid(region)) solid_ = solid_of<D>(region);
    else mesh_ = region.loaded;
    fluid_inside_ = region.side == Side::inside;
  }

  /// The distance of x from the surface [m]: positive on the fluid's side, negative on the other.
  double distance(Vec<D, double> x) const {
    if (!mesh_) return solid_.distance(x);
    if constexpr (D == 3) {
      if (!mesh_->condition.closed()) return mesh_->distance.nearest(x).distance - sheet_ / 2;
      const double outside = mesh_->distance.signed_distance(x);
      return fluid_inside_ ? -outside : outside;
    } else {
      const double away = mesh_->distance.nearest({x.x, x.y, 0}).distance;
      return encloses(mesh_->outline, x) == fluid_inside_ ? away : -away;
    }
  }

 private:
  Solid<D, double> solid_;
  std::shared_ptr<const LoadedMesh> mesh_;
  double sheet_;
  bool fluid_inside_;
};

}  // namespace freshet

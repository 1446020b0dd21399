// SPDX-License-Identifier: MIT
#pragma once
#include "scene/model/free_surface.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/solid_of.h"

namespace freshet {

/// The surface of a region, except of points, of a scene with its defaults filled in, or the free
/// surface of a fluid. An open mesh is a sheet as thick as one spacing.
template <int D> class RegionSurface {
 public:
  RegionSurface(const Scene::Region& region, double spacing) : sheet_(spacing) {
    if (is_solid(region)) solid_ = solid_of<D>(region);
    else mesh_ = region.loaded;
    fluid_inside_ = region.side == Side::inside;
  }
  explicit RegionSurface(const Solid<D, double>& solid)
      : solid_(solid), sheet_(0), fluid_inside_(solid.fluid_inside) {}
  explicit RegionSurface(const FreeSurface& top) : top_(top), sheet_(0), fluid_inside_(true) {}

  /// Whether this is a mesh with holes.
  bool is_sheet() const { return mesh_ && !mesh_->condition.closed(); }

  /// Whether this is the free surface of a fluid.
  bool is_free() const { return top_.has_value(); }
  /// The distance of x from the surface [m]: positive on the fluid's side, negative on the other.
  double distance(Vec<D, double> x) const {
    if (top_) return top_->distance(x);
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
  /// The unit normal at the point of the surface nearest to x; it points towards the fluid. 0 if x
  /// is on a mesh.
  Vec<D, double> normal(Vec<D, double> x) const {
    if (top_) return top_->normal(x);
    if (!mesh_) return solid_.normal(x);
    const auto away = x - nearest(x);
    const double length = norm(away);
    if (length == 0) return {};
    return (distance(x) < 0 ? -1 / length : 1 / length) * away;
  }

 private:
  Vec<D, double> nearest(Vec<D, double> x) const {
    if constexpr (D == 3) {
      return mesh_->distance.nearest(x).point;
    } else {
      const auto on = mesh_->distance.nearest({x.x, x.y, 0}).point;
      return {on.x, on.y};
    }
  }

  Solid<D, double> solid_;
  std::optional<FreeSurface> top_;
  std::shared_ptr<const LoadedMesh> mesh_;
  double sheet_;
  bool fluid_inside_;
};

}  // namespace freshet

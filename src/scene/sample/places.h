// SPDX-License-Identifier: MIT
/// The places of the particles of one fluid, before jitter and pressure move them. They are
/// relative to origin_of() the scene.
#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "scene/model/openings.h"
#include "scene/model/setup.h"
#include "scene/sample/point_grid.h"
#include "scene/sample/region_surface.h"

namespace freshet {

/// Whether a fluid fills its whole lattice.
inline bool is_block(const Scene::Fluid& f) {
  return f.shape == Shape::lattice || (f.shape == Shape::box && f.side == Side::inside &&
                                       f.surface.empty() && !is_turned_box(f));
}

/// Vectors from a place to its images beyond periodic ends; the first is 0.
template <int D> std::vector<Vec<D, double>> periodic_shifts(const Scene& s) {
  std::vector<Vec<D, double>> shifts{{}};
  for (int k = 0; k < D; ++k) {
    if (!s.periodic(k)) continue;
    const double length = s.domain.max[std::size_t(k)] - s.domain.min[std::size_t(k)];
    for (std::size_t j = 0, n = shifts.size(); j < n; ++j)
      for (const double sign : {-1.0, 1.0}) {
        auto shift = shifts[j];
        component(shift, k) += sign * length;
        shifts.push_back(shift);
      }
  }
  return shifts;
}

struct Box {
  Vector min, max;
};
/// The box that the lattice of a fluid is aligned to. Its top is a row above the free surface, if
/// the fluid has one. Not for a lattice or points.
Box box_around(const Scene& scene, const Scene::Fluid& fluid);

/// Whether a fluid keeps half a spacing from a side of the domain.
bool keeps_distance(const Scene& scene, const Scene::Fluid& fluid, int side);

/// The places of a fluid. `scene` has its defaults filled in and must outlive this.
template <int D> class Places {
 public:
  Places(const Scene& scene, const Scene::Fluid& fluid);

  /// Calls visit(x, i) for each place until it returns false; i is the index of a point of a file.
  /// Returns the number of places that are excluded because of walls, but not by the free surface.
  template <class F> std::int64_t each(F visit) const {
    std::int64_t left_out = 0;
    each_of_lattice([&](Vec<D> x, std::size_t i) {
      if (!in_shape(x)) return true;
      if (!in_wall(x)) return bool(visit(x, i));
      left_out += side_clearance(in_scene(x)) < margin_ || is_barred(x);
      return true;
    });
    return left_out;
  }
  /// Calls visit(x, i) for each point of the file or lattice until it returns false.
  template <class F> void each_of_lattice(F look) const {
    bool on = true;
    for (std::size_t i = 0; i < points_.size() && on; ++i) on = look(points_[i], i);
    if (!is_lattice()) return;
    for (std::int64_t layer = 0; layer < (D == 3 ? lattice_.count[D - 1] : 1) && on; ++layer)
      for (std::int64_t row = 0; row < lattice_.count[1] && on; ++row)
        for (std::int64_t column = 0; column < lattice_.count[0] && on; ++column)
          on = look(place({column, row, layer}), 0);
  }
  bool is_lattice() const { return !lattice_.count.empty(); }
  /// For a lattice: whether one of its places is closer to x than half a spacing.
  bool comes_near(Vec<D> x) const;
  /// The distance of x from the shape's surface [m], positive inside; infinite if the fluid fills
  /// its whole lattice.
  double depth(Vec<D, double> x) const { return shape_ ? shape_->distance(x) : INFINITY; }
  /// The distance of x from the nearest side, wall or body with an inside, or from the free surface
  /// [m], negative behind it. Particles keep half a spacing from the surface as from a wall.
  double clearance(Vec<D, double> x) const;
  /// As clearance(), without the free surface.
  double side_clearance(Vec<D, double> x) const;
  /// The distance of x from the nearest wall or body with an inside [m], negative inside.
  double wall_clearance(Vec<D, double> x) const;
  /// Whether x is excluded by what has no inside: zones of inlets, walls of points and sheets.
  bool is_barred(Vec<D> x) const;
  /// The number of places that are excluded by what has no inside alone.
  std::int64_t barred() const {
    std::int64_t count = 0;
    if (!zones_.empty() || !sheets_.empty() || !wall_points_.empty())
      each_of_lattice([&](Vec<D> x, std::size_t) {
        count += in_shape(x) && clearance(in_scene(x)) >= margin_ && is_barred(x);
        return true;
      });
    return count;
  }
  bool in_shape(Vec<D> x) const { return depth(in_scene(x)) > 1e-6 * spacing_; }
  bool in_wall(Vec<D> x) const { return clearance(in_scene(x)) < margin_ || is_barred(x); }
  /// The velocities of the points of a file; empty without them.
  const std::vector<Vec<D>>& velocities() const { return velocities_; }
  /// The densities and pressures of a run's frame; empty without them.
  const std::vector<double>& densities() const { return densities_; }
  const std::vector<double>& pressures() const { return pressures_; }
  /// The position in the scene of a place [m].
  Vec<D, double> in_scene(Vec<D> x) const { return origin_ + to_double(x); }
  /// The place at a position in the scene [m].
  Vec<D> place_at(Vec<D, double> x) const {
    Vec<D> place{};
    x = x - origin_;
    for (int k = 0; k < D; ++k) component(place, k) = Real(component(x, k));
    return place;
  }

 private:
  Vec<D> place(const std::array<std::int64_t, 3>& n) const {
    Vec<D> x{};
    for (int k = 0; k < D; ++k)
      component(x, k) =
          Real(lattice_.from[std::size_t(k)]) + Real(n[std::size_t(k)]) * Real(spacing_);
    return x;
  }

  double spacing_;
  Vec<D, double> origin_{};
  Lattice lattice_;  // from: relative to the origin
  std::vector<Vec<D>> points_, velocities_;
  std::vector<double> densities_, pressures_;
  std::optional<RegionSurface<D>> shape_;  // empty: every place is inside
  std::optional<FreeSurface> top_;
  std::vector<RegionSurface<D>> walls_, sheets_;  // and bodies
  std::vector<Vec<D, double>> shifts_;
  std::vector<InletZone<D>> zones_;  // of inlets
  /// From walls, bodies and zones [m]: half a spacing, less the rounding error of a position (see
  /// check_resolution). 0 for the points of a file, which are where they should be.
  double margin_;
  Vector low_, high_;  // of the domain; infinite at sides without a distance
  PointGrid<D> wall_points_;
};

extern template class Places<2>;
extern template class Places<3>;

/// Pairs of fluids, the earlier first, with particles less than half a spacing apart. Checks only
/// the fluids of `good`.
std::vector<std::pair<std::size_t, std::size_t>> overlapping_fluids(
    const Scene& scene, const std::vector<std::size_t>& good);

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Evenly spread points, about one spacing apart, in layers behind the surface of a shape.
#pragma once
#include <functional>

#include "scene/model/setup.h"
#include "scene/model/solid_of.h"

namespace freshet {

template <int D> class Surface {
 public:
  using Point = Vec<D, double>;

  /// The first of `layers` layers is half a spacing behind the surface.
  Surface(const Solid<D, double>& solid, double spacing, int layers)
      : solid_(solid), spacing_(spacing), layers_(layers) {}

  /// The points of all layers. Only a plane reads the arguments: its points are in the box from
  /// `low` to `high`, and have the spacing of `cell` along axes.
  std::vector<Point> points(Point low, Point high, Point cell);

 private:
  void box();
  void ball(double radius);
  void cylinder(double radius, double half_length);
  void plane(double behind, Point low, Point high, Point cell);
  void disc(Point center, Point u, Point v, double radius);
  /// False if the radius is so small that no further ring fits inside.
  bool ring(Point center, Point u, Point v, double radius);

  const Solid<D, double>& solid_;
  double spacing_;
  int layers_;
  std::vector<Point> all_;
};

/// Calls f with the indices of each cell around a lattice of `n` cells, at most `beyond` cells away
/// along each axis. Cells inside the lattice are skipped. The last axis is slowest.
template <int D, class F> void around_lattice(const Counts& n, const Counts& beyond, F f) {
  Counts c(3, 0);
  const std::int64_t z_low = D == 3 ? -beyond.back() : 0;
  const std::int64_t z_high = D == 3 ? n.back() + beyond.back() : 1;
  for (c[2] = z_low; c[2] < z_high; ++c[2])
    for (c[1] = -beyond[1]; c[1] < n[1] + beyond[1]; ++c[1]) {
      const bool across = (D == 3 && (c[2] < 0 || c[2] >= n.back())) || c[1] < 0 || c[1] >= n[1];
      for (c[0] = -beyond[0]; c[0] < n[0] + beyond[0]; ++c[0]) {
        if (!across && c[0] == 0 && n[0] > 0) c[0] = n[0];
        if (c[0] < n[0] + beyond[0]) f(c);
      }
    }
}

extern template class Surface<2>;
extern template class Surface<3>;

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/sample/sample_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "scene/sample/akinci_layer.h"
#include "scene/sample/places.h"
#include "scene/sample/point_cloud.h"
#include "scene/sample/region_layers.h"
#include "scene/sample/region_surface.h"

namespace freshet {
namespace {

WallSample& sample_of(Sample& all, WallMethod method) {
  return method == WallMethod::akinci2012  ? all.akinci2012
         : method == WallMethod::adami2012 ? all.adami2012
                                           : all.monaghan2009;
}

/// Appends a boundary particle at x in a scene of this origin.
template <int D>
void append(WallSample& to, Vec<D, double> x, const Triple& origin, std::int32_t wall,
            Real volume_factor = 1) {
  for (int k = 0; k < D; ++k) to.x.push_back(Real(component(x, k) - origin[std::size_t(k)]));
  to.wall.push_back(wall);
  to.volume_factor.push_back(volume_factor);
}

/// The domain divided into cells about a spacing wide, and the number of cells beyond each end that
/// may have boundary particles.
struct SideLattice {
  Counts n, beyond;
  Vector cell;
  explicit SideLattice(const Scene& s) {
    std::int64_t layers = 0;
    for (int side = 0; side < 2 * s.dimension(); ++side)
      if (!s.periodic(side / 2))
        layers = std::max<std::int64_t>(layers, wall_layers(s, s.side_method(side)));
    for (int k = 0; k < s.dimension(); ++k) {
      const auto j = std::size_t(k);
      const double length = s.domain.max[j] - s.domain.min[j];
      n.push_back(
          std::max<std::int64_t>(1, std::llround(std::min(length / s.particles.spacing, 9e15))));
      cell.push_back(length / double(n.back()));
      const bool images = s.periodic(k) && layers > 0;
      beyond.push_back(images ? std::int64_t(std::ceil(support_radius(s) / cell.back())) : layers);
    }
  }
};

/// The side that a cell beyond the domain belongs to, or -1. A cell in a corner belongs to the
/// first side whose method has enough layers.
int side_of(const Scene& s, const Counts& c, const Counts& n) {
  std::int64_t deepest = 0;
  int sides[3], count = 0;
  for (int k = 0; k < s.dimension(); ++k) {
    const auto j = std::size_t(k);
    if (s.periodic(k) || (c[j] >= 0 && c[j] < n[j])) continue;
    deepest = std::max(deepest, c[j] < 0 ? -c[j] : c[j] - n[j] + 1);
    sides[count++] = 2 * k + (c[j] >= 0);
  }
  for (int i = 0; i < count; ++i)
    if (deepest <= wall_layers(s, s.side_method(sides[i]))) return sides[i];
  return -1;
}

template <int D> void sample_sides(const Scene& s, Sample& all) {
  const SideLattice lattice(s);
  if (lattice.beyond == Counts(D, 0)) return;
  const double akinci_setback = single_layer_distance(s) - s.particles.spacing;
  const Triple origin = origin_of(s);
  around_lattice<D>(lattice.n, lattice.beyond, [&](const Counts& c) {
    const int side = side_of(s, c, lattice.n);
    if (side < 0) return;
    bool image = false;
    Vec<D, double> x{};
    const double deeper = s.side_method(side) == WallMethod::akinci2012 ? akinci_setback : 0;
    for (int k = 0; k < D; ++k) {
      const auto j = std::size_t(k);
      image |= s.periodic(k) && (c[j] < 0 || c[j] >= lattice.n[j]);
      component(x, k) = s.domain.min[j] + (double(c[j]) + 0.5) * lattice.cell[j];
      if (!s.periodic(k) && c[j] < 0) component(x, k) -= deeper;
      if (!s.periodic(k) && c[j] >= lattice.n[j]) component(x, k) += deeper;
    }
    append(sample_of(all, s.side_method(side)), x, origin, image ? -1 - side : side);
  });
}

/// A box that may have boundary particles.
template <int D> struct Room {
  Vec<D, double> low, high;
  bool has(Vec<D, double> x) const {
    Vec<D, double> l = low, h = high;
    for (int k = 0; k < D; ++k)
      if (component(x, k) < component(l, k) || component(x, k) > component(h, k)) return false;
    return true;
  }
};

/// The domain and one support radius around it. No particle interacts with anything beyond.
template <int D> Room<D> domain_and_support(const Scene& s) {
  Room<D> room{vec_of<D>(s.domain.min), vec_of<D>(s.domain.max)};
  for (int k = 0; k < D; ++k) {
    component(room.low, k) -= support_radius(s);
    component(room.high, k) += support_radius(s);
  }
  return room;
}

/// Points behind the surface. A mesh with holes has no inside; its points are on the surface.
std::vector<Vec<3, double>> mesh_samples(const Scene& s, std::size_t wall) {
  const Scene::Wall& w = s.wall[wall];
  const WallMethod method = s.wall_method(wall);
  if (method == WallMethod::adami2012)
    return layers_behind(w.loaded->distance, s.particles.spacing, wall_layers(s, method),
                         w.side == Side::inside);
  const double depth =
      method == WallMethod::akinci2012 ? AkinciLayer(s).depth() : s.particles.spacing / 2;
  const double inwards = w.side == Side::outside ? depth : -depth;
  return points_behind(w.loaded->distance, s.particles.spacing,
                       w.loaded->condition.closed() ? inwards : 0);
}

template <int D> std::vector<Vec<D, double>> surface_points(const Scene& s, std::size_t wall) {
  const Scene::Wall& w = s.wall[wall];
  std::vector<Vec<D, double>> points;
  if (w.shape == Shape::points) {
    const std::vector<double> x = region_points(w, D).x;
    for (std::size_t i = 0; i < x.size(); i += D) {
      Vec<D, double> a{};
      for (int k = 0; k < D; ++k) component(a, k) = x[i + std::size_t(k)];
      points.push_back(a);
    }
    return points;
  }
  if constexpr (D == 3)
    if (w.shape == Shape::mesh) return mesh_samples(s, wall);
  const int layers = wall_layers(s, s.wall_method(wall));
  std::optional<AkinciLayer> akinci;
  if (s.wall_method(wall) == WallMethod::akinci2012) akinci.emplace(s);
  if constexpr (D == 2)
    if (w.shape == Shape::polygon)
      return layers_of_polygon(w, s.particles.spacing, layers, akinci ? akinci->setback() : 0);
  const auto solid = solid_of<D>(w);
  const SideLattice lattice(s);
  Room<D> room{vec_of<D>(s.domain.min), vec_of<D>(s.domain.max)};
  const auto cell = vec_of<D>(lattice.cell);
  for (int k = 0; k < D; ++k) {
    const double beyond = double(lattice.beyond[std::size_t(k)]) * lattice.cell[std::size_t(k)];
    component(room.low, k) -= beyond;
    component(room.high, k) += beyond;
  }
  points = Surface<D>(solid, s.particles.spacing, layers).points(room.low, room.high, cell);
  if (akinci)
    for (auto& x : points) akinci->settle(solid, x);
  turn_with<D>(w, points);
  return points;
}

/// The depths of boundary particles behind the surface give their volumes. Points of a file have no
/// surface.
template <int D>
std::vector<Real> volume_factors(const Scene& s, std::size_t wall,
                                 const std::vector<Vec<D, double>>& points) {
  std::vector<Real> factors(points.size(), 1);
  if (s.wall_method(wall) != WallMethod::akinci2012 || s.wall[wall].shape == Shape::points)
    return factors;
  const AkinciLayer layer(s);
  const RegionSurface<D> surface(s.wall[wall], s.particles.spacing);
  std::transform(points.begin(), points.end(), factors.begin(),
                 [&](const auto& x) { return layer.volume_factor(s.wall[wall], surface, x); });
  return factors;
}

/// Samples a wall. The part beyond a periodic end is repeated at the opposite end.
template <int D> void sample_wall(const Scene& s, std::size_t wall, Sample& all) {
  const Room<D> room = domain_and_support<D>(s),
                domain{vec_of<D>(s.domain.min), vec_of<D>(s.domain.max)};
  const bool repeats = s.wall[wall].shape != Shape::plane;  // a plane extends beyond by itself
  const auto shifts = repeats ? periodic_shifts<D>(s) : std::vector<Vec<D, double>>(1);
  WallSample& to = sample_of(all, s.wall_method(wall));
  const auto points = surface_points<D>(s, wall);
  const auto factors = volume_factors<D>(s, wall, points);
  const Triple origin = origin_of(s);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const Vec<D, double>& shift : shifts) {
      Vec<D, double> x = points[i] + shift, low = domain.low, high = domain.high;
      if (!room.has(x)) continue;
      bool image = false;
      for (int k = 0; k < D; ++k)
        image |= s.periodic(k) &&
                 (component(x, k) < component(low, k) || component(x, k) >= component(high, k));
      const auto number = std::int32_t(2 * D + int(wall));
      append(to, x, origin, image ? -1 - number : number, factors[i]);
    }
}

double shell(const Vector& cells, double layers) {
  double inside = 1, all = 1;
  for (const double n : cells) {
    inside *= n;
    all *= n + 2 * layers;
  }
  return all - inside;
}

}  // namespace

double most_samples(const Scene& s, const Scene::Region& w, double layers) {
  const double spacing = s.particles.spacing, r = w.radius / spacing + layers + 2;
  const double l = w.length / spacing + 2 * layers + 2, pi = std::numbers::pi;
  Vector sides;
  if (w.shape == Shape::sphere)
    return layers * (w.center.size() == 2 ? 2 * pi * r : 4 * pi * r * r);
  if (w.shape == Shape::mesh)  // upper bound: a layer outside is wider than the surface
    return 5 * layers * (w.loaded->distance.area() / square(spacing) + 100);
  if (w.shape == Shape::polygon)  // upper bound: likewise
    return 3 * layers * (perimeter_of(w.loaded->outline) / spacing + 100);
  if (w.shape == Shape::cylinder) return layers * (2 * pi * r * l + 2 * pi * r * r);
  if (w.shape == Shape::box)
    for (std::size_t k = 0; k < w.min.size(); ++k)
      sides.push_back((w.max[k] - w.min[k]) / spacing + 1);
  if (w.shape == Shape::plane)  // upper bound: the shell around the domain
    for (std::size_t k = 0; k < w.normal.size(); ++k)
      sides.push_back((s.domain.max[k] - s.domain.min[k]) / spacing + 2 * layers + 2);
  return shell(sides, layers);
}

int wall_layers(const Scene& s, WallMethod method) {
  if (method == WallMethod::adami2012)
    return int(std::min(std::ceil(support_radius(s) / s.particles.spacing * (1 - 1e-9)), 1e6));
  return method == WallMethod::akinci2012 || method == WallMethod::monaghan2009;
}

double most_wall_samples(const Scene& s) {
  double layers = 0, all = 0;
  for (int side = 0; side < 2 * s.dimension(); ++side)
    if (!s.periodic(side / 2))
      layers = std::max<double>(layers, wall_layers(s, s.side_method(side)));
  Vector sides;
  for (std::size_t k = 0; k < s.domain.max.size(); ++k)
    sides.push_back((s.domain.max[k] - s.domain.min[k]) / s.particles.spacing + 1);
  if (layers > 0) all += shell(sides, s.domain.periodic == Axes::none ? layers : layers + 10);
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (const int n = wall_layers(s, s.wall_method(k)); n > 0 && s.wall[k].shape != Shape::points)
      all += most_samples(s, s.wall[k], n);
  return all;
}

template <int D> void sample_walls(const Scene& s, Sample& all) {
  sample_sides<D>(s, all);
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (wall_layers(s, s.wall_method(k)) > 0) sample_wall<D>(s, k, all);
}

template void sample_walls<2>(const Scene&, Sample&);
template void sample_walls<3>(const Scene&, Sample&);

}  // namespace freshet

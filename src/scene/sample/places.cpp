// SPDX-License-Identifier: MIT
#include "scene/sample/places.h"

#include <algorithm>
#include <cmath>

#include "scene/sample/point_cloud.h"

namespace freshet {
namespace {

/// The box around the part of the domain on the inner side of a plane.
Box box_below(const Scene& s, const Scene::Region& plane) {
  Box box{s.domain.min, s.domain.max};
  const std::size_t n = box.min.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double along = plane.normal[k];
    if (along == 0) continue;
    double reach = along * plane.point[k];  // maximum of along · x_k over the other axes
    for (std::size_t j = 0; j < n; ++j)
      if (j != k)
        reach += plane.normal[j] * plane.point[j] -
                 std::min(plane.normal[j] * s.domain.min[j], plane.normal[j] * s.domain.max[j]);
    if (along > 0) box.max[k] = std::clamp(reach / along, box.min[k], box.max[k]);
    else box.min[k] = std::clamp(reach / along, box.min[k], box.max[k]);
  }
  return box;
}

/// The vectors of these numbers, relative to an origin.
template <int D>
std::vector<Vec<D>> vectors(const std::vector<double>& numbers, const Triple& origin = {}) {
  std::vector<Vec<D>> all(numbers.size() / D);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    component(all[i / D], int(i % D)) = Real(numbers[i] - origin[i % D]);
  return all;
}

/// The maximum height of a free surface over a box.
template <int D> double highest(const FreeSurface& top, const Box& box, double spacing) {
  double most = -INFINITY;
  each_column(vec_of<D>(box.min), vec_of<D>(box.max), spacing / 2,
              [&](Vec<D, double> x, Vec<D, double>) { most = std::max(most, top.height(x)); });
  return most;
}

/// Lowers the top of a box to a row above the free surface, so that few rows are empty.
void cut(Box& box, const Scene& s, const Scene::Fluid& f) {
  const double spacing = s.particles.spacing;
  const FreeSurface top(f.surface, s.dimension(), spacing);
  const double most =
      s.dimension() == 2 ? highest<2>(top, box, spacing) : highest<3>(top, box, spacing);
  const double rows = std::ceil((most - box.min[1]) / spacing + 0.5);
  box.max[1] = std::clamp(box.min[1] + rows * spacing, box.min[1], box.max[1]);
}

Box box_of_shape(const Scene& s, const Scene::Fluid& f) {
  if (f.side == Side::outside) {
    if (f.shape != Shape::plane) return {s.domain.min, s.domain.max};
    Scene::Region turned = f;
    for (double& component : turned.normal) component = -component;
    return box_below(s, turned);
  }
  if (is_mesh(f)) {
    const auto low = f.loaded->distance.low(), high = f.loaded->distance.high();
    if (s.dimension() == 2) return {{low.x, low.y}, {high.x, high.y}};
    return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
  }
  if (f.shape == Shape::box) return {f.min, f.max};
  if (f.shape == Shape::plane) return box_below(s, f);
  Box box{f.center, f.center};
  double axis2 = 0;
  for (const double a : f.axis) axis2 += a * a;
  for (std::size_t k = 0; k < f.center.size(); ++k) {
    double reach = f.radius;
    if (f.shape == Shape::cylinder) {
      const double along = std::abs(f.axis[k]) / std::sqrt(axis2);
      reach = along * f.length / 2 + f.radius * std::sqrt(std::max(0.0, 1 - along * along));
    }
    box.min[k] -= reach;
    box.max[k] += reach;
  }
  return box;
}

}  // namespace

Box box_around(const Scene& s, const Scene::Fluid& f) {
  Box box = box_of_shape(s, f);
  if (!f.surface.empty() && f.shape != Shape::lattice) cut(box, s, f);
  return box;
}

double Lattice::particles() const {
  double n = count.empty() ? 0 : 1;
  for (const auto c : count) n *= double(c);
  return n;
}

Vector Lattice::last(double spacing) const {
  Vector end = from;
  for (std::size_t k = 0; k < end.size(); ++k) end[k] += double(count[k] - 1) * spacing;
  return end;
}

Lattice lattice_of(const Scene& s, const Scene::Fluid& f) {
  const double spacing = s.particles.spacing;
  if (f.shape == Shape::points) return {};
  if (f.shape == Shape::lattice) return {f.from, f.count};
  const Box box = box_around(s, f);
  Lattice lattice{box.min, {}};
  for (std::size_t k = 0; k < box.min.size(); ++k) {
    lattice.from[k] += spacing / 2;
    const double n = std::round((box.max[k] - box.min[k]) / spacing);
    lattice.count.push_back(std::int64_t(std::fmin(n, 9e15)));
  }
  return lattice;
}

bool keeps_distance(const Scene& s, const Scene::Fluid& f, int side) {
  const bool as_given = f.shape == Shape::lattice || f.shape == Shape::points;
  return !as_given && f.outside != Outside::clamp && !s.periodic(side / 2) && !s.is_open(side);
}

template <int D>
Places<D>::Places(const Scene& s, const Scene::Fluid& f)
    : spacing_(s.particles.spacing),
      lattice_(lattice_of(s, f)),
      low_(D, -INFINITY),
      high_(D, INFINITY),
      wall_points_(0.499 * spacing_) {
  if (!is_block(f) && f.shape != Shape::points) shape_.emplace(f, spacing_);
  if (!f.surface.empty() && f.shape != Shape::lattice) top_.emplace(f.surface, D, spacing_);
  const Triple origin = origin_of(s);
  for (int k = 0; k < D; ++k) component(origin_, k) = origin[std::size_t(k)];
  for (std::size_t k = 0; k < lattice_.from.size(); ++k) lattice_.from[k] -= origin[k];
  shifts_ = periodic_shifts<D>(s);
  const bool of_file = f.shape == Shape::points;
  margin_ = of_file ? 0 : 0.49 * spacing_;
  for (int side = 0; side < 2 * D; ++side)
    if (const auto k = std::size_t(side / 2); keeps_distance(s, f, side)) {
      if (side % 2) high_[k] = s.domain.max[k];
      else low_[k] = s.domain.min[k];
    }
  const double sheet = of_file ? 0 : spacing_;
  const auto add = [&](const Scene::Region& region) {
    const RegionSurface<D> surface(region, sheet);
    (surface.is_sheet() ? sheets_ : walls_).push_back(surface);
  };
  for (const Scene::Wall& w : s.wall)
    if (w.shape != Shape::points) add(w);
    else if (!of_file)
      for (const Vec<D>& x : vectors<D>(region_points(w, D).x, origin))
        wall_points_.add(to_double(x));
  for (const Scene::Inlet& in : s.inlet) zones_.emplace_back(s, in);
  for (const Scene::Body& b : s.body) add(b);
  if (f.shape != Shape::points) return;
  PointCloud cloud = points_of(f, D);
  points_ = vectors<D>(cloud.x, origin);
  velocities_ = vectors<D>(cloud.v);
  densities_ = std::move(cloud.density);
  pressures_ = std::move(cloud.pressure);
}

template <int D> double Places<D>::clearance(Vec<D, double> x) const {
  return top_ ? std::min(side_clearance(x), top_->distance(x)) : side_clearance(x);
}

template <int D> double Places<D>::side_clearance(Vec<D, double> x) const {
  double least = wall_clearance(x);
  for (std::size_t k = 0; k < D; ++k) {
    const double at = component(x, int(k));
    least = std::min({least, at - low_[k], high_[k] - at});
  }
  return least;
}

template <int D> double Places<D>::wall_clearance(Vec<D, double> x) const {
  double least = INFINITY;
  for (const auto& wall : walls_)
    for (const auto& shift : shifts_) least = std::min(least, wall.distance(x + shift));
  return least;
}

template <int D> bool Places<D>::is_barred(Vec<D> x) const {
  const Vec<D, double> place = in_scene(x);
  for (const auto& zone : zones_)
    if (zone.holds(place, margin_)) return true;
  for (const auto& sheet : sheets_)
    for (const auto& shift : shifts_)
      if (sheet.distance(place + shift) < margin_) return true;
  return !wall_points_.empty() && wall_points_.comes_near(to_double(x));
}

template <int D> bool Places<D>::comes_near(Vec<D> x) const {
  std::array<std::int64_t, 3> nearest{};
  for (int k = 0; k < D; ++k) {
    const auto j = std::size_t(k);
    const double n = (double(component(x, k)) - lattice_.from[j]) / spacing_;
    if (!(n > -0.5 && n < double(lattice_.count[j]) - 0.5)) return false;
    nearest[j] = std::int64_t(std::round(n));
  }
  const Vec<D> a = place(nearest);
  return double(norm2(a - x)) < square(0.499 * spacing_) && in_shape(a) && !in_wall(a);
}

template class Places<2>;
template class Places<3>;

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/sample/fluid_volume.h"

#include <algorithm>
#include <cmath>

#include "scene/sample/places.h"

namespace freshet {
namespace {

/// The box around the fluid, inside the domain unless the places are given.
Box room_of(const Scene& s, const Scene::Fluid& f) {
  const double half = s.particles.spacing / 2;
  if (f.shape == Shape::lattice) {
    Box box{f.from, lattice_of(s, f).last(s.particles.spacing)};
    for (double& x : box.min) x -= half;
    for (double& x : box.max) x += half;
    return box;
  }
  Box box = box_around(s, f);
  for (std::size_t k = 0; k < box.min.size(); ++k) {
    box.min[k] = std::clamp(box.min[k], s.domain.min[k], s.domain.max[k]);
    box.max[k] = std::clamp(box.max[k], s.domain.min[k], s.domain.max[k]);
  }
  return box;
}

/// Divides a box until its pieces are inside the fluid, outside, or small. The share of a small
/// piece follows from the distance of its centre, so it is exact where a face is along an axis.
/// Below a free surface, each column of the box is divided by itself.
template <int D> class Measure {
 public:
  Measure(const Scene& s, const Scene::Fluid& f)
      : places_(s, f), box_(room_of(s, f)), spacing_(s.particles.spacing) {
    if (!f.surface.empty()) top_.emplace(f.surface, D, spacing_);
    double longest = 0;
    for (std::size_t k = 0; k < D; ++k) longest = std::max(longest, box_.max[k] - box_.min[k]);
    smallest_ = std::max(spacing_ / 4, longest / 256);
  }
  double volume() const {
    const auto low = vec_of<D>(box_.min), high = vec_of<D>(box_.max);
    const double barred = double(places_.barred()) * std::pow(spacing_, D);
    if (!top_) return volume(0.5 * (low + high), 0.5 * (high - low)) - barred;
    double all = 0;
    each_column(low, high, spacing_ / 4, [&](Point x, Point width) {
      const double top = std::min(top_->height(x), high.y), height = top - low.y;
      if (!(height > 0)) return;
      x.y = low.y + height / 2;
      width.y = height;
      all += volume(x, 0.5 * width);
    });
    return all - barred;
  }

 private:
  using Point = Vec<D, double>;
  double volume(Point center, Point half) const {
    double all = 1;
    int longest = 0;
    for (int k = 0; k < D; ++k) {
      all *= 2 * component(half, k);
      if (component(half, k) > component(half, longest)) longest = k;
    }
    const double distance = room(center), side = 2 * component(half, longest);
    if (all == 0 || distance <= -norm(half)) return 0;
    if (distance >= norm(half)) return all;
    if (side <= smallest_) return all * share(center, half, distance);
    component(half, longest) /= 2;
    Point step{};
    component(step, longest) = component(half, longest);
    return volume(center - step, half) + volume(center + step, half);
  }

  double room(Point x) const { return std::min(places_.depth(x), places_.wall_clearance(x)); }
  /// The share of a box on the fluid's side of the plane at a distance from its centre.
  double share(Point center, Point half, double distance) const {
    double extent = 0;  // of the box along the normal
    for (int k = 0; k < D; ++k) {
      Point step{};
      component(step, k) = component(half, k);
      extent += std::abs(room(center + step) - room(center - step));
    }
    return extent > 0 ? std::clamp(0.5 + distance / extent, 0.0, 1.0) : double(distance > 0);
  }

  Places<D> places_;
  Box box_;
  std::optional<FreeSurface> top_;
  double spacing_, smallest_;
};

}  // namespace

double volume_asked(const Scene& s, const Scene::Fluid& f) {
  return s.dimension() == 2 ? Measure<2>(s, f).volume() : Measure<3>(s, f).volume();
}

}  // namespace freshet

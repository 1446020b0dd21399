// SPDX-License-Identifier: MIT
#include "run/film_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/bodies.h"
#include "render/floor.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

constexpr double outliers = 0.002;         // share of the particles beyond each side of the box
constexpr double smallest = 12;            // side of the box [particle spacings]
constexpr double touch = 2;                // distance of liquid that touches a side [spacings]
constexpr double wall_surplus = 0.25;      // of walls around the liquid, in sizes of the liquid
constexpr double rim = 0.12;               // of a tank above the liquid, in its height
constexpr double longest_shutter = 0.004;  // [s]
constexpr double shutter_share = 0.25;     // of the time between two pictures

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Bounds empty{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

template <class P> auto& part(P& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

void extend(Bounds& box, const Bounds& by) {
  for (int a = 0; a < 3; ++a) {
    part(box.low, a) = std::min(part(box.low, a), part(by.low, a));
    part(box.high, a) = std::max(part(box.high, a), part(by.high, a));
  }
}

Bounds common(const Bounds& a, const Bounds& b) {
  Bounds box = a;
  for (int k = 0; k < 3; ++k) {
    part(box.low, k) = std::max(part(a.low, k), part(b.low, k));
    part(box.high, k) = std::min(part(a.high, k), part(b.high, k));
  }
  return box;
}

bool is_empty(const Bounds& b) {
  return !(b.low.x <= b.high.x && b.low.y <= b.high.y && b.low.z <= b.high.z);
}

Bounds domain_of(const Scene& scene) {
  return {point_of(scene.domain.min), point_of(scene.domain.max)};
}

Bounds bounds_of(const TriangleMesh& mesh) {
  Bounds box = empty;
  for (const Point& p : mesh.points) extend(box, {p, p});
  return box;
}

/// The box around the particles, except for a few that fly far from the others.
Bounds bounds_of(const Frame& frame) {
  Bounds box = empty;
  std::vector<float> values(frame.size());
  if (values.empty()) return box;
  const auto skipped = std::ptrdiff_t(outliers * double(values.size()));
  for (int a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = frame.x[3 * i + std::size_t(a)];
    std::nth_element(values.begin(), values.begin() + skipped, values.end());
    part(box.low, a) = double(values[std::size_t(skipped)]);
    std::nth_element(values.begin(), values.end() - 1 - skipped, values.end());
    part(box.high, a) = double(*(values.end() - 1 - skipped));
  }
  return box;
}

Bounds enlarged(Bounds box, double by) {
  return {box.low - Point{by, by, by}, box.high + Point{by, by, by}};
}

}  // namespace

FilmViewer::FilmViewer(const Scene& scene) : scene_(scene), liquid_(empty), bodies_(empty) {}

void FilmViewer::add_time(double time) { times_.push_back(time); }

void FilmViewer::add(const Frame& frame) {
  add_time(frame.time);
  extend(liquid_, bounds_of(frame));
  add_bodies(frame);
}

void FilmViewer::add_bodies(const Frame& frame) {
  if (frame.bodies.empty()) return;
  for (const TriangleMesh& mesh : posed_bodies(scene_, frame)) extend(bodies_, bounds_of(mesh));
}

/// Extends the box by the part of a wall that is near the liquid.
void FilmViewer::add_wall(const Bounds& wall, Bounds& seen) const {
  Bounds near = liquid_;
  for (int a = 0; a < 3; ++a) {
    const double surplus = wall_surplus * (part(liquid_.high, a) - part(liquid_.low, a));
    part(near.low, a) -= surplus;
    part(near.high, a) += surplus;
  }
  const Bounds shown = common(wall, near);
  if (!is_empty(shown)) extend(seen, shown);
}

FilmView FilmViewer::view() const {
  const Bounds domain = domain_of(scene_);
  const double spacing = scene_.particles.spacing;
  FilmView view;
  view.seen = is_empty(liquid_) ? domain : enlarged(liquid_, spacing / 2);
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double gap = side % 2 ? part(domain.high, axis) - part(liquid_.high, axis)
                                : part(liquid_.low, axis) - part(domain.low, axis);
    view.touched[std::size_t(side)] = gap < touch * spacing;
  }
  const double height = view.seen.high.y - view.seen.low.y;
  view.tank_top = std::min(domain.high.y, view.seen.high.y + std::max(rim * height, 2 * spacing));
  for (const Scene::Wall& wall : scene_.wall) {
    if (is_mesh(wall) && wall.loaded) add_wall(bounds_of(wall.loaded->distance.mesh()), view.seen);
    else if (is_solid(wall) && wall.shape != Shape::plane)
      add_wall(freshet::bounds_of(solid_of<3>(wall)), view.seen);
  }
  if (!is_empty(bodies_)) extend(view.seen, bodies_);
  if (const Bounds inside = common(view.seen, domain); !is_empty(inside)) view.seen = inside;
  for (int a = 0; a < 3; ++a) {
    const double missing = smallest * spacing - (part(view.seen.high, a) - part(view.seen.low, a));
    if (missing <= 0) continue;
    part(view.seen.low, a) -= missing / 2;
    part(view.seen.high, a) += missing / 2;
  }
  double gap = longest_shutter / shutter_share;
  for (std::size_t k = 1; k < times_.size(); ++k)
    if (times_[k] != times_[k - 1]) gap = std::min(gap, std::abs(times_[k] - times_[k - 1]));
  view.shutter = std::min(longest_shutter, shutter_share * gap);
  return view;
}

}  // namespace freshet

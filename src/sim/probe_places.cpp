// SPDX-License-Identifier: MIT
#include "sim/probe_places.h"

#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "scene/body_shape.h"
#include "scene/probe_plane.h"

namespace freshet {
namespace {

constexpr int surface_places_per_spacing = 4;

std::vector<Vector> along_line(const Scene::Probe& p, std::int64_t count) {
  std::vector<Vector> places;
  for (std::int64_t k = 0; k < count; ++k) {
    Vector x;
    for (std::size_t d = 0; d < p.from.size(); ++d)
      x.push_back(p.from[d] + (p.to[d] - p.from[d]) * double(k) / double(count - 1));
    places.push_back(x);
  }
  return places;
}

/// x first.
std::vector<Vector> in_plane(const Scene& s, const Scene::Probe& p) {
  std::vector<Vector> places{p.from};
  for (std::size_t d = p.from.size(); d-- > 0;) {
    const std::int64_t steps = steps_of_plane(s, p, d);
    std::vector<Vector> more;
    for (const Vector& place : places)
      for (std::int64_t k = 0; k <= steps; ++k) {
        more.push_back(place);
        if (k > 0) more.back()[d] += (p.to[d] - p.from[d]) * double(k) / double(steps);
      }
    places = std::move(more);
  }
  return places;
}

std::vector<Vector> places_of(const Scene& s, const Scene::Probe& p) {
  switch (p.kind) {
    case ProbeKind::point:
      return {p.at};
    case ProbeKind::line:
      return along_line(p, p.count);
    case ProbeKind::plane:
      return in_plane(s, p);
    case ProbeKind::surface:
      break;
  }
  double length2 = 0;
  for (std::size_t d = 0; d < p.from.size(); ++d)
    length2 += (p.to[d] - p.from[d]) * (p.to[d] - p.from[d]);
  return along_line(p, 1 + std::int64_t(std::ceil(std::sqrt(length2) / s.particles.spacing *
                                                  surface_places_per_spacing)));
}

Vec<3, double> in_3d(const Vector& x) { return {x[0], x[1], x.size() > 2 ? x[2] : 0}; }

}  // namespace

ProbePlaces::ProbePlaces(const Scene& scene) {
  for (const Scene::Probe& p : scene.probe) {
    start_.push_back(places_of(scene, p));
    carriers_.emplace_back();
    for (std::size_t b = 0; b < scene.body.size(); ++b)
      if (!p.body.empty() && scene.body_name(b) == p.body)
        carriers_.back() = Carrier{b, body_shape(scene.body[b]).center};
  }
}

bool ProbePlaces::move() const {
  return std::any_of(carriers_.begin(), carriers_.end(), [](const auto& c) { return bool(c); });
}

std::vector<std::vector<Vector>> ProbePlaces::now(const std::vector<BodyState>& bodies) const {
  auto places = start_;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!carriers_[k]) continue;
    const BodyState& body = bodies[carriers_[k]->body];
    const Rotation turn(body.orientation);
    for (Vector& place : places[k]) {
      Vec<3, double> arm = turn(in_3d(place) - carriers_[k]->center);
      for (std::size_t d = 0; d < place.size(); ++d)
        place[d] = body.position[d] + component(arm, int(d));
    }
  }
  return places;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "sim/probe_places.h"

#include <algorithm>
#include <cmath>

#include "core/in_3d.h"
#include "core/rotation.h"
#include "scene/model/body_shape.h"
#include "scene/model/probe_patch.h"
#include "scene/model/probe_plane.h"

namespace freshet {
namespace {

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
    case ProbeKind::wall:
      return {};
    case ProbeKind::surface:
      break;
  }
  return along_line(p, 1 + std::int64_t(steps_of_surface(s, p)));
}

}  // namespace

ProbePlaces::ProbePlaces(const Scene& scene) : scene_(scene) {
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

Vector ProbePlaces::carried(const Carrier& by, const std::vector<BodyState>& bodies,
                            const Vector& place) {
  const BodyState& body = bodies[by.body];
  const Vec<3, double> position{body.position[0], body.position[1], body.position[2]};
  return in_scene(position + Rotation(body.orientation)(in_3d(place) - by.center), place.size());
}

std::vector<std::vector<Vector>> ProbePlaces::now(const std::vector<BodyState>& bodies) const {
  auto places = start_;
  for (std::size_t k = 0; k < places.size(); ++k)
    if (carriers_[k])
      for (Vector& place : places[k]) place = carried(*carriers_[k], bodies, place);
  return places;
}

std::vector<WallPatch> ProbePlaces::patches(const std::vector<BodyState>& bodies) const {
  std::vector<WallPatch> all;
  for (std::size_t k = 0; k < scene_.probe.size(); ++k) {
    if (scene_.probe[k].kind != ProbeKind::wall) continue;
    all.push_back(patch_of(scene_.probe[k]));
    if (!carriers_[k]) continue;
    WallPatch& patch = all.back();
    patch.center = carried(*carriers_[k], bodies, patch.center);
    const Rotation turn(bodies[carriers_[k]->body].orientation);
    for (Vector& axis : patch.axes) axis = in_scene(turn(in_3d(axis)), axis.size());
  }
  return all;
}

}  // namespace freshet

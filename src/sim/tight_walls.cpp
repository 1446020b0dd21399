// SPDX-License-Identifier: MIT
#include "sim/tight_walls.h"

#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;

Point point_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

Point in_scene(const ParticleView& f, std::size_t i) {
  Point at{};
  for (std::size_t k = 0; k < std::size_t(f.dimension); ++k)
    component(at, int(k)) = f.position(i, k);
  return at;
}

/// The unit normal of a triangle on the side that a way comes from.
Point normal_against(const TriangleMesh& mesh, int triangle, Point way) {
  const auto corners = mesh.corners(triangle);
  const Point area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return (dot(area, way) < 0 ? 1 : -1) / norm(area) * area;
}

}  // namespace

/// Where a body is, or the identity.
class TightWalls::Pose {
 public:
  explicit Pose(const std::array<double, 3>& period) : period_(period) {}
  Pose(const BodyState& state, Point start, const std::array<double, 3>& period)
      : turn_(Rotation(state.orientation)),
        position_(point_of(state.position)),
        start_(start),
        period_(period) {}

  /// A point of the scene, or its image that is nearest to the body.
  Point to_start(Point x) const {
    if (!turn_) return x;
    return turn_->inverse(nearest_image(x - position_)) + start_;
  }
  Point direction(Point a) const { return turn_ ? (*turn_)(a) : a; }
  /// The shortest of a way and its images.
  Point nearest_image(Point way) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (period_[k] > 0)
        component(way, int(k)) = std::remainder(component(way, int(k)), period_[k]);
    return way;
  }

 private:
  std::optional<Rotation> turn_;
  Point position_{}, start_{};
  std::array<double, 3> period_;
};

TightWalls::TightWalls(const Scene& s, const Derived& d, Bodies* bodies)
    : dimension_(std::size_t(s.dimension())), reach_(d.support_radius), bodies_(bodies) {
  if (!s.method().has_boundary_particles() || !has_fluid(s)) return;
  for (std::size_t k = 0; k < dimension_; ++k)
    if (s.periodic(int(k))) period_[k] = s.domain.max[k] - s.domain.min[k];
  for (const Scene::Liquid& liquid : s.liquids())
    masses_.push_back(d.mass * liquid.rest_density / d.rest_density);
  Point low{}, high{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    component(low, int(k)) = s.domain.min[k];
    component(high, int(k)) = s.domain.max[k];
  }
  for (Membrane& membrane : membranes_of(s, 2 * d.support_radius)) {
    const bool rests = membrane.body < 0;
    const MeshDistance& m = membrane.surface;
    NearCells near(dimension_, rests ? low : m.low(), rests ? high : m.high(), m.mesh(), reach_);
    guards_.push_back({std::move(membrane), std::move(near), 0, {}});
  }
  for (Guard& guard : guards_) {
    if (guard.membrane.body < 0) continue;
    if (!cells_) cells_.emplace(s, 4 * reach_);
    const Point center = point_of(bodies_->center(std::size_t(guard.membrane.body)));
    Point below = center - guard.membrane.surface.low(),
          above = guard.membrane.surface.high() - center;
    double radius2 = 0;
    for (int k = 0; k < int(dimension_); ++k)
      radius2 += square(std::max(component(below, k), component(above, k)) + reach_);
    guard.radius = std::sqrt(radius2);
  }
}

TightWalls::Pose TightWalls::pose_of(const Guard& guard) const {
  if (guard.membrane.body < 0) return Pose(period_);
  const auto k = std::size_t(guard.membrane.body);
  return {bodies_->states()[k], point_of(bodies_->center(k)), period_};
}

/// The particles that may be near each membrane.
std::vector<std::vector<std::size_t>> TightWalls::candidates(const ParticleView& f) {
  if (cells_) cells_->clear();
  for (std::size_t g = 0; g < guards_.size(); ++g)
    if (guards_[g].membrane.body >= 0)
      cells_->add(int(g),
                  point_of(bodies_->states()[std::size_t(guards_[g].membrane.body)].position),
                  guards_[g].radius);
  std::vector<std::vector<std::size_t>> all(guards_.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    const Point x = in_scene(f, i);
    for (std::size_t g = guards_.size(); g-- > 0 && guards_[g].membrane.body < 0;)
      if (guards_[g].near.has(x)) all[g].push_back(i);
    if (!cells_) continue;
    for (const int g : cells_->at(x)) all[std::size_t(g)].push_back(i);
  }
  return all;
}

void TightWalls::begin(const ParticleView& f) {
  const auto near = candidates(f);
  for (std::size_t g = 0; g < guards_.size(); ++g) {
    Guard& guard = guards_[g];
    const Pose pose = pose_of(guard);
    guard.starts.clear();
    for (const std::size_t i : near[g])
      if (const Point x = pose.to_start(in_scene(f, i)); guard.near.has(x))
        guard.starts.push_back({f.id[i], x});
    std::sort(guard.starts.begin(), guard.starts.end());
  }
}

std::int64_t TightWalls::hold(Engine& engine) {
  std::int64_t stopped = 0;
  const auto near = candidates(engine.fluid());
  for (std::size_t g = 0; g < guards_.size(); ++g) {
    const Guard& guard = guards_[g];
    if (guard.starts.empty()) continue;
    const Pose pose = pose_of(guard);
    const std::vector<Held> all = crossings(guard, pose, engine.fluid(), near[g]);
    for (const Held& one : all) apply(one, guard.membrane.body, pose, engine);
    stopped += std::int64_t(all.size());
  }
  return stopped;
}

/// The particles that crossed a membrane, in the order of their ids: each may push a free body.
std::vector<TightWalls::Held> TightWalls::crossings(const Guard& guard, const Pose& pose,
                                                    const ParticleView& f,
                                                    const std::vector<std::size_t>& near) const {
  std::vector<Held> all;
  for (const std::size_t i : near) {
    const Point now = pose.to_start(in_scene(f, i));
    if (!guard.near.has(now)) continue;
    const auto start =
        std::lower_bound(guard.starts.begin(), guard.starts.end(), Start{f.id[i], {}});
    if (start == guard.starts.end() || start->id != f.id[i]) continue;
    Point way = now - start->x;
    if (guard.membrane.body < 0) way = pose.nearest_image(way);
    if (norm(way) > reach_) continue;  // an image of a body, or a run that has blown up
    if (auto one = held(guard.membrane, start->x, way)) {
      one->place = i;
      one->id = f.id[i];
      all.push_back(*one);
    }
  }
  std::sort(all.begin(), all.end(), [](const Held& a, const Held& b) { return a.id < b.id; });
  return all;
}

void TightWalls::apply(const Held& one, int body, const Pose& pose, Engine& engine) const {
  const ParticleView f = engine.fluid();
  const Point place = in_scene(f, one.place);
  const std::span<Real> x = engine.positions().subspan(dimension_ * one.place, dimension_),
                        v = engine.velocities().subspan(dimension_ * one.place, dimension_);
  const double mass = masses_[std::size_t(f.liquid_of(one.place))];
  stop(v, mass, place, pose.direction(one.normal), body);
  if (one.second_normal) stop(v, mass, place, pose.direction(*one.second_normal), body);
  Point move = pose.direction(one.move);
  for (std::size_t k = 0; k < dimension_; ++k) x[k] += Real(component(move, int(k)));
}

/// What becomes of a particle if its way crosses a membrane.
std::optional<TightWalls::Held> TightWalls::held(const Membrane& m, Point from, Point way) {
  const auto crossing = [&](Point to) { return m.surface.first_crossing(from, to, m.two_sided); };
  const auto first = crossing(from + way);
  if (!first) return {};
  const Point normal = normal_against(m.surface.mesh(), first->triangle, way);
  const Point slid = way - dot(way, normal) * normal;
  const auto second = crossing(from + slid);
  if (!second) return Held{0, 0, slid - way, normal, {}};
  return Held{0, 0, -1 * way, normal, normal_against(m.surface.mesh(), second->triangle, slid)};
}

/// Removes the part of the velocity of a particle, relative to the body, that points against a
/// normal.
void TightWalls::stop(std::span<Real> v, double mass, Point x, Point normal, int body) const {
  Point relative{};
  for (std::size_t k = 0; k < dimension_; ++k) component(relative, int(k)) = double(v[k]);
  BodyState* state = body < 0 ? nullptr : &bodies_->states()[std::size_t(body)];
  const Point arm = state ? x - point_of(state->position) : Point{};
  if (state)
    relative =
        relative - (point_of(state->velocity) + cross(point_of(state->angular_velocity), arm));
  const double along = dot(relative, normal);
  if (!(along < 0)) return;
  const auto mobility = state ? bodies_->mobility(std::size_t(body)) : std::array<SixNumbers, 6>{};
  Point turn = cross(arm, normal), push = normal;
  SixNumbers unit{}, answer{};
  for (int k = 0; k < 3; ++k) {
    unit[std::size_t(k)] = component(push, k);
    unit[std::size_t(3 + k)] = component(turn, k);
  }
  double lightness = 1 / mass;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) answer[i] += mobility[i][j] * unit[j];
    lightness += answer[i] * unit[i];
  }
  const double impulse = -along / lightness;
  for (std::size_t k = 0; k < dimension_; ++k)
    v[k] += Real(impulse / mass * component(push, int(k)));
  for (std::size_t k = 0; k < 3 && state; ++k) {
    state->velocity[k] -= impulse * answer[k];
    state->angular_velocity[k] -= impulse * answer[3 + k];
  }
}

}  // namespace freshet

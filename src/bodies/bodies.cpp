// SPDX-License-Identifier: MIT
#include "bodies/bodies.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bodies/rigid_world.h"
#include "boundary/open_sides.h"
#include "core/rotation.h"
#include "scene/model/body_motion.h"
#include "scene/model/expressions.h"
#include "scene/model/setup.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

using Point = Vec<3, double>;

Point point_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
std::array<double, 3> array_of(Point p) { return {p.x, p.y, p.z}; }
Point in_space(const Vector& v) { return {v[0], v[1], v.size() == 3 ? v[2] : 0.0}; }
Point direction_of(const Vector& v) { return v.size() == 3 ? unit_of<3>(v) : Point{0, 0, 1}; }

Point times(const double (&m)[3][3], Point a) {
  return {m[0][0] * a.x + m[0][1] * a.y + m[0][2] * a.z,
          m[1][0] * a.x + m[1][1] * a.y + m[1][2] * a.z,
          m[2][0] * a.x + m[2][1] * a.y + m[2][2] * a.z};
}

Point unit_along(int axis) { return {double(axis == 0), double(axis == 1), double(axis == 2)}; }

/// m^-1 a for a symmetric positive definite m.
Point solve(const double (&m)[3][3], Point a) {
  const Point r0{m[0][0], m[0][1], m[0][2]}, r1{m[1][0], m[1][1], m[1][2]},
      r2{m[2][0], m[2][1], m[2][2]};
  const Point c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
  return (a.x * c0 + a.y * c1 + a.z * c2) / dot(r0, c0);
}

using Tensor = double[3][3];

/// The inverse of an inertia tensor that is turned with its body, about the free axes of space
/// while the others are held.
void invert_turned(const Tensor& inertia, const Rotation& turn, const bool (&free)[3],
                   Tensor& inverse) {
  Tensor held{};  // in space, without what couples free axes with locked ones
  for (int j = 0; j < 3; ++j) {
    Point column = turn(times(inertia, turn.inverse(unit_along(j))));
    for (int i = 0; i < 3; ++i)
      if (i == j || (free[i] && free[j])) held[i][j] = component(column, i);
  }
  const bool all = free[0] && free[1] && free[2];
  for (int j = 0; j < 3; ++j) {
    if (!free[j]) continue;
    const Point unit = unit_along(j);
    Point column = all ? turn(solve(inertia, turn.inverse(unit))) : solve(held, unit);
    for (int i = 0; i < 3; ++i) inverse[i][j] = component(column, i);
  }
}

}  // namespace

struct Bodies::Impl {
  explicit Impl(const Scene& s) : scene(s), body_force(s.domain.body_force) {
    for (const Scene::Body& b : s.body) {
      shapes.push_back(body_shape(b));
      motions.emplace_back();
      if (b.motion == BodyMotion::moved) motions.back().emplace(b, s.dimension());
      any_free |= b.motion == BodyMotion::free;
    }
    if (any_free) world.emplace(s, shapes);
  }
  /// Whether a body at x with this acceleration is too far outside to come back or to touch fluid.
  bool has_left(std::size_t k, Point x, Point a) const {
    OpenSides<3> sides{in_space(scene.domain.min), in_space(scene.domain.max),
                       2 * (shapes[k].reach + support_radius(scene)), 0, 0};
    for (int side = 0; side < 2 * scene.dimension(); ++side) {
      const unsigned bit = 1u << side;
      if (scene.is_open(side)) sides.open |= bit;
      else if (!scene.periodic(side / 2)) sides.closed |= bit;
    }
    return sides.left_through(x, a) >= 0;
  }

  const Scene& scene;
  std::vector<BodyShape> shapes;
  std::vector<std::optional<PrescribedMotion>> motions;
  std::optional<RigidWorld> world;
  Expressions body_force;
  bool any_free = false;
};

Bodies::Bodies(const Scene& s) : impl_(std::make_unique<Impl>(s)) {
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& b = s.body[k];
    BodyState state;
    state.position = array_of(impl_->shapes[k].center);
    if (b.motion == BodyMotion::free) {
      state.velocity = array_of(in_space(b.velocity));
      state.angular_velocity = array_of(b.angular_velocity * direction_of(b.turn_axis));
    }
    states_.push_back(state);
  }
  last_forces_.resize(states_.size());
  pushes_.resize(states_.size());
  for (std::size_t k = 0; k < size(); ++k) states_[k] = placed(k, 0);
}
Bodies::~Bodies() = default;

std::array<double, 3> Bodies::center(std::size_t k) const {
  return array_of(impl_->shapes[k].center);
}
bool Bodies::any_free() const { return impl_->any_free; }

void Bodies::save() {
  saved_states_ = states_;
  saved_forces_ = last_forces_;
}
void Bodies::restore() {
  states_ = saved_states_;
  last_forces_ = saved_forces_;
}

/// A moved body is at x = pivot + R (x0 - pivot) + translation.
BodyState Bodies::placed(std::size_t k, double time) const {
  BodyState state = states_[k];
  if (!impl_->motions[k]) return state;
  const Scene::Body& b = impl_->scene.body[k];
  const Displacement d = impl_->motions[k]->at(time);
  const Point axis = direction_of(b.turn_axis), center = impl_->shapes[k].center,
              pivot = b.pivot.empty() ? center : in_space(b.pivot), omega = d.rate[3] * axis;
  state.orientation = rotation_by(d.value[3] * axis);
  const Point arm = Rotation(state.orientation)(center - pivot);
  state.position = array_of(pivot + arm + Point{d.value[0], d.value[1], d.value[2]});
  state.velocity = array_of(Point{d.rate[0], d.rate[1], d.rate[2]} + cross(omega, arm));
  state.angular_velocity = array_of(omega);
  return state;
}

BodyState Bodies::at(std::size_t k, double time, double ahead) const {
  BodyState state = placed(k, time + ahead);
  if (ahead == 0 || impl_->scene.body[k].motion != BodyMotion::free) return state;
  state.position = array_of(point_of(state.position) + ahead * point_of(state.velocity));
  state.orientation =
      product(rotation_by(ahead * point_of(state.angular_velocity)), state.orientation);
  return state;
}

std::array<SixNumbers, 6> Bodies::mobility(std::size_t k) const {
  std::array<SixNumbers, 6> m{};
  const Scene::Body& b = impl_->scene.body[k];
  if (b.motion != BodyMotion::free) return m;
  const double mass = impl_->shapes[k].mass, density = impl_->shapes[k].density();
  const Rotation turn(states_[k].orientation);
  const Point center = point_of(states_[k].position);
  for (const Scene::Joint& joint : impl_->scene.joint) {
    if (joint.body != impl_->scene.body_name(k)) continue;
    const auto other =
        std::find_if(impl_->scene.body.begin(), impl_->scene.body.end(), [&](const Scene::Body& o) {
          return impl_->scene.body_name(std::size_t(&o - impl_->scene.body.data())) == joint.other;
        });
    if (other != impl_->scene.body.end() && other->motion == BodyMotion::free) continue;
    const Point axis = direction_of(joint.axis),
                swing = cross(axis, center - in_space(joint.point));
    const double inertia =
        density * dot(axis, turn(times(impl_->shapes[k].inertia, turn.inverse(axis)))) +
        mass * norm2(swing);
    const SixNumbers u{swing.x, swing.y, swing.z, axis.x, axis.y, axis.z};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) m[i][j] = u[i] * u[j] / inertia;
    return m;
  }
  const auto free = freedoms_of(b, impl_->scene.dimension());
  for (std::size_t i = 0; i < 3; ++i)
    if (free[i]) m[i][i] = 1 / mass;
  if (impl_->scene.dimension() == 2) {
    if (free[5]) m[5][5] = 1 / (density * impl_->shapes[k].inertia[2][2]);
    return m;
  }
  Tensor inverse{};
  invert_turned(impl_->shapes[k].inertia, turn, {free[3], free[4], free[5]}, inverse);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[3 + i][3 + j] = inverse[i][j] / density;
  return m;
}

SixNumbers Bodies::pull(std::size_t k, double time) const {
  if (impl_->scene.body[k].motion != BodyMotion::free) return {};
  SixNumbers load = pushes_[k];
  double b[3] = {};
  if (!impl_->body_force.empty()) {
    const auto& p = states_[k].position;
    impl_->body_force({p[0], p[1], p[2]}, time, b);
  }
  for (std::size_t d = 0; d < impl_->scene.domain.gravity.size(); ++d)
    load[d] += impl_->shapes[k].mass * (impl_->scene.domain.gravity[d] + b[d]);
  return load;
}

void Bodies::step(double time, double dt, std::span<const SixNumbers> forces) {
  std::vector<Load> loads;
  for (std::size_t k = 0; k < size(); ++k) {
    BodyState& state = states_[k];
    const SixNumbers pulled = pull(k, time);
    Load load;
    for (std::size_t d = 0; d < 3; ++d) {
      load.force[d] = pulled[d] + (state.force[d] = forces[k][d]);
      load.torque[d] = pulled[3 + d] + (state.torque[d] = forces[k][3 + d]);
    }
    loads.push_back(load);
    state = placed(k, time);
  }
  if (impl_->world) impl_->world->step(states_, loads, dt);
  for (std::size_t k = 0; k < size(); ++k) states_[k] = placed(k, time + dt);
}

double Bodies::fastest(double time) const {
  double most = 0;
  for (std::size_t k = 0; k < size(); ++k) {
    const BodyState state = at(k, time, 0);
    const SixNumbers load = pull(k, time);
    const bool free = impl_->scene.body[k].motion == BodyMotion::free;
    if (free && impl_->has_left(k, point_of(state.position), {load[0], load[1], load[2]})) continue;
    most = std::max(most, norm(point_of(state.velocity)) +
                              impl_->shapes[k].reach * norm(point_of(state.angular_velocity)));
  }
  return most;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "bodies/rigid_world.h"

#include <algorithm>

#ifdef FRESHET_BULLET
#include "bodies/body_axes.h"
#include "bodies/rigid_step.h"
#include "scene/model/solid_of.h"
#endif

namespace freshet {

#ifdef FRESHET_BULLET

namespace {

btQuaternion orientation_of(const BodyState& state) {
  const auto& q = state.orientation;
  return {q[0], q[1], q[2], q[3]};
}

}  // namespace

struct RigidWorld::Impl {
  /// A body in Bullet's axes, in which its inertia is diagonal.
  struct Body {
    Collider collider;
    btQuaternion turn = btQuaternion::getIdentity();
    double mass = 0;
    btVector3 inertia{0, 0, 0};
    std::array<bool, 6> free{};
    // of the part of a compound collider, from the centre of mass at the start
    btTransform part_place = btTransform::getIdentity();
  };

  const Scene& scene;
  const std::vector<BodyShape>& shapes;
  bool flat;
  std::vector<Body> bodies;
  std::vector<Collider> walls;

  Impl(const Scene& s, const std::vector<BodyShape>& b)
      : scene(s), shapes(b), flat(s.dimension() == 2), walls(wall_colliders(s)) {
    for (std::size_t k = 0; k < s.body.size(); ++k) bodies.push_back(body(k));
  }

  Body body(std::size_t k) const {
    const Scene::Body& b = scene.body[k];
    const BodyShape& shape = shapes[k];
    Body out;
    const bool free = b.motion == BodyMotion::free;
    if (free) out.mass = shape.mass;
    out.free = freedoms_of(b, scene.dimension());
    out.collider = body_collider(scene, k, shape, out.turn);
    const bool other_axes =
        !flat && (!turns_freely(out.free) || (!b.inertia.empty() && !is_hull(b)));
    if (free && (other_axes || !b.center_of_mass.empty())) compound(b, shape, out);
    const btMatrix3x3 inertia = inertia_of(shape, btMatrix3x3(out.turn).transpose());
    for (int d = 0; d < 3; ++d) out.inertia[d] = shape.density() * inertia[d][d];
    if (flat) out.inertia[0] = out.inertia[1] = 0;  // Bullet: infinite; it turns about z only
    if (flat && !out.free[5]) out.inertia[2] = 0;
    return out;
  }
  /// Makes the collider a part of a compound: the axes of its shape are then no longer those of the
  /// inertia, or the centre of the shape is not that of mass.
  void compound(const Scene::Body& b, const BodyShape& shape, Body& out) const {
    Collider& c = out.collider;
    c.part = std::move(c.shape);
    out.part_place.setRotation(out.turn);
    if (!is_hull(b)) out.part_place.setOrigin(bullet(shape.middle - shape.center));
    if (!flat) out.turn = principal_axes(inertia_of(shape)).turn;
    auto all = std::make_unique<btCompoundShape>(false);
    all->addChildShape(btTransform(out.turn).inverse() * out.part_place, c.part.get());
    c.shape = std::move(all);
  }
  /// The axes and the inertia of a body in a step that begins with its rotation q. About locked
  /// axes, the inertia is 0, which Bullet takes as infinite.
  BodyAxes axes(std::size_t k, const btQuaternion& q) const {
    const Body& body = bodies[k];
    if (flat || body.mass == 0 || turns_freely(body.free)) return {body.turn, body.inertia};
    BodyAxes held = principal_axes(uncoupled(inertia_of(shapes[k], btMatrix3x3(q)), body.free));
    held.inertia *= shapes[k].density();
    for (int d = 0; d < 3; ++d)
      if (!body.free[std::size_t(3 + d)]) held.inertia[d] = 0;
    held.turn = q.inverse() * held.turn;
    static_cast<btCompoundShape&>(*body.collider.shape)
        .updateChildTransform(0, btTransform(held.turn).inverse() * body.part_place);
    return held;
  }
  /// -omega x (inertia omega), which Bullet does not have for a body with locked axes: its inertia
  /// there lacks the elements that matter.
  btVector3 gyroscopic_torque(std::size_t k, const btQuaternion& q, const btVector3& omega) const {
    return -shapes[k].density() * omega.cross(inertia_of(shapes[k], btMatrix3x3(q)) * omega);
  }

  std::size_t named(const std::string& name) const {
    std::size_t k = 0;
    while (scene.body_name(k) != name) ++k;
    return k;
  }

  btRigidBody& add_body(RigidStep& step, std::size_t k, const BodyAxes& axes,
                        const BodyState& state, const Load& load) const {
    const Scene::Body& of = scene.body[k];
    const btQuaternion turned = orientation_of(state);
    const btTransform place(turned * axes.turn, bullet(state.position));
    btRigidBody& b = step.add(bodies[k].mass, axes.inertia, place, &bodies[k].collider);
    b.setFriction(of.friction);
    b.setRestitution(of.restitution);
    const btVector3 v = bullet(state.velocity), omega = bullet(state.angular_velocity);
    if (of.motion == BodyMotion::moved) {
      b.setCollisionFlags(b.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
      b.setLinearVelocity(v);
      b.setAngularVelocity(omega);
    } else if (of.motion == BodyMotion::free) {
      const auto& free = bodies[k].free;
      b.setLinearFactor(btVector3(free[0], free[1], free[2]));
      b.setAngularFactor(btVector3(free[3], free[4], free[5]));
      if (!flat && !turns_freely(free)) {
        b.setFlags(0);  // no gyroscopic torque by Bullet
        b.applyTorque(gyroscopic_torque(k, turned, omega));
      }
      b.setLinearVelocity(v);
      b.setAngularVelocity(omega);
      b.applyCentralForce(bullet(load.force));
      b.applyTorque(bullet(load.torque));
    }
    return b;
  }

  void add_hinges(RigidStep& step, const std::vector<btRigidBody*>& all,
                  const std::vector<btQuaternion>& turns, double dt) const {
    btRigidBody* world = nullptr;
    for (const Scene::Joint& joint : scene.joint) {
      // the hinge in the axes of each of the two bodies, from their initial positions
      const auto at = [&](std::size_t k, const btVector3& x) {
        return btMatrix3x3(turns[k]).transpose() * (x - bullet(shapes[k].center));
      };
      const auto along = [&](std::size_t k, const btVector3& a) {
        return btMatrix3x3(turns[k]).transpose() * a;
      };
      const std::size_t k = named(joint.body);
      const btVector3 x = bullet(joint.point),
                      a = flat ? btVector3(0, 0, 1) : bullet(joint.axis).normalized();
      std::unique_ptr<btHingeConstraint> hinge;
      if (joint.other.empty()) {
        if (!world) world = &step.add(0, {0, 0, 0}, btTransform::getIdentity(), nullptr);
        hinge = std::make_unique<btHingeConstraint>(*all[k], *world, at(k, x), x, along(k, a), a);
      } else {
        const std::size_t j = named(joint.other);
        hinge = std::make_unique<btHingeConstraint>(*all[k], *all[j], at(k, x), at(j, x),
                                                    along(k, a), along(j, a));
      }
      btHingeConstraint& added = step.hinge(std::move(hinge));
      if (joint.motor_speed)
        added.enableAngularMotor(true, *joint.motor_speed, joint.motor_torque.value_or(0) * dt);
    }
  }

  /// Reads what is free; locked coordinates keep their bits.
  void read(const btRigidBody& b, std::size_t k, const btQuaternion& turn, BodyState& state) const {
    const auto& free = bodies[k].free;
    const auto move = [&](auto& to, const btVector3& by, std::size_t first) {
      for (std::size_t d = 0; d < 3; ++d)
        if (free[first + d]) to[d] = by[int(d)];
    };
    move(state.position, b.getWorldTransform().getOrigin(), 0);
    move(state.velocity, b.getLinearVelocity(), 0);
    move(state.angular_velocity, b.getAngularVelocity(), 3);
    btQuaternion q = b.getWorldTransform().getRotation() * turn.inverse();
    q.normalize();
    if (free[3] || free[4] || free[5]) state.orientation = {q.x(), q.y(), q.z(), q.w()};
  }
};

RigidWorld::RigidWorld(const Scene& scene, const std::vector<BodyShape>& shapes)
    : impl_(std::make_unique<Impl>(scene, shapes)) {}
RigidWorld::~RigidWorld() = default;

void RigidWorld::step(std::vector<BodyState>& states, std::span<const Load> loads, double dt) {
  const Impl& w = *impl_;
  RigidStep step(w.scene);
  std::vector<btRigidBody*> all;
  std::vector<btQuaternion> turns;  // from the axes of a body to Bullet's
  for (std::size_t k = 0; k < states.size(); ++k) {
    const BodyAxes axes = w.axes(k, orientation_of(states[k]));
    turns.push_back(axes.turn);
    all.push_back(&w.add_body(step, k, axes, states[k], loads[k]));
  }
  for (const Collider& wall : w.walls) step.add(0, {0, 0, 0}, wall.place, &wall);
  w.add_hinges(step, all, turns, dt);
  step.advance(dt);
  for (std::size_t k = 0; k < states.size(); ++k)
    if (w.scene.body[k].motion == BodyMotion::free) w.read(*all[k], k, turns[k], states[k]);
}

#else

struct RigidWorld::Impl {};
RigidWorld::RigidWorld(const Scene&, const std::vector<BodyShape>&) {}
RigidWorld::~RigidWorld() = default;
void RigidWorld::step(std::vector<BodyState>&, std::span<const Load>, double) {}

#endif

}  // namespace freshet

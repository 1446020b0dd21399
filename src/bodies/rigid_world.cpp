// SPDX-License-Identifier: MIT
#include "bodies/rigid_world.h"

#include <algorithm>

#ifdef FRESHET_BULLET
#include "bodies/rigid_step.h"
#endif

namespace freshet {

#ifdef FRESHET_BULLET

namespace {

std::array<double, 3> array(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

struct RigidWorld::Impl {
  /// A body in Bullet's axes, in which its inertia is diagonal.
  struct Body {
    Collider collider;
    btQuaternion turn = btQuaternion::getIdentity();
    double mass = 0;
    btVector3 inertia{0, 0, 0};
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
    if (b.motion == BodyMotion::free)
      out.mass = b.mass.value_or(b.density.value_or(0) * shape.volume);
    out.collider = body_collider(scene, k, shape, out.turn);
    const btMatrix3x3 turn(out.turn);
    const btMatrix3x3 inertia = turn.transpose() * bullet(shape.inertia) * turn;
    for (int d = 0; d < 3; ++d) out.inertia[d] = out.mass / shape.volume * inertia[d][d];
    if (flat) out.inertia[0] = out.inertia[1] = 0;  // Bullet: infinite; it turns about z only
    return out;
  }

  std::size_t named(const std::string& name) const {
    std::size_t k = 0;
    while (scene.body_name(k) != name) ++k;
    return k;
  }

  btRigidBody& add_body(RigidStep& step, std::size_t k, const BodyState& state,
                        const Load& load) const {
    const Scene::Body& of = scene.body[k];
    const auto& q = state.orientation;
    const btTransform place(btQuaternion(q[0], q[1], q[2], q[3]) * bodies[k].turn,
                            bullet(state.position));
    btRigidBody& b = step.add(bodies[k].mass, bodies[k].inertia, place, &bodies[k].collider);
    b.setFriction(of.friction);
    b.setRestitution(of.restitution);
    const btVector3 v = bullet(state.velocity), omega = bullet(state.angular_velocity);
    if (of.motion == BodyMotion::moved) {
      b.setCollisionFlags(b.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
      b.setLinearVelocity(v);
      b.setAngularVelocity(omega);
    } else if (of.motion == BodyMotion::free) {
      if (flat) {
        b.setLinearFactor({1, 1, 0});
        b.setAngularFactor({0, 0, 1});
      }
      b.setLinearVelocity(v);
      b.setAngularVelocity(omega);
      b.applyCentralForce(bullet(load.force));
      b.applyTorque(bullet(load.torque));
    }
    return b;
  }

  void add_hinges(RigidStep& step, const std::vector<btRigidBody*>& all, double dt) const {
    btRigidBody* world = nullptr;
    for (const Scene::Joint& joint : scene.joint) {
      // the hinge in the axes of each of the two bodies, from their initial positions
      const auto at = [&](std::size_t k, const btVector3& x) {
        return btMatrix3x3(bodies[k].turn).transpose() * (x - bullet(shapes[k].center));
      };
      const auto along = [&](std::size_t k, const btVector3& a) {
        return btMatrix3x3(bodies[k].turn).transpose() * a;
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

  void read(const btRigidBody& b, std::size_t k, BodyState& state) const {
    btQuaternion q = b.getWorldTransform().getRotation() * bodies[k].turn.inverse();
    q.normalize();
    state.position = array(b.getWorldTransform().getOrigin());
    state.orientation = {q.x(), q.y(), q.z(), q.w()};
    state.velocity = array(b.getLinearVelocity());
    state.angular_velocity = array(b.getAngularVelocity());
  }
};

RigidWorld::RigidWorld(const Scene& scene, const std::vector<BodyShape>& shapes)
    : impl_(std::make_unique<Impl>(scene, shapes)) {}
RigidWorld::~RigidWorld() = default;

void RigidWorld::step(std::vector<BodyState>& states, std::span<const Load> loads, double dt) {
  const Impl& w = *impl_;
  RigidStep step(w.scene);
  std::vector<btRigidBody*> all;
  for (std::size_t k = 0; k < states.size(); ++k)
    all.push_back(&w.add_body(step, k, states[k], loads[k]));
  for (const Collider& wall : w.walls) step.add(0, {0, 0, 0}, wall.place, &wall);
  w.add_hinges(step, all, dt);
  step.advance(dt);
  for (std::size_t k = 0; k < states.size(); ++k)
    if (w.scene.body[k].motion == BodyMotion::free) w.read(*all[k], k, states[k]);
}

#else

struct RigidWorld::Impl {};
RigidWorld::RigidWorld(const Scene&, const std::vector<BodyShape>&) {}
RigidWorld::~RigidWorld() = default;
void RigidWorld::step(std::vector<BodyState>&, std::span<const Load>, double) {}

#endif

}  // namespace freshet

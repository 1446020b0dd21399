// SPDX-License-Identifier: MIT
#include "bodies/rigid_world.h"

#include <algorithm>

#ifdef FRESHET_BULLET
#include "bodies/body_axes.h"
#include "scene/model/body_mesh.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/solid_of.h"
#endif

namespace freshet {

#ifdef FRESHET_BULLET

namespace {

using Point = Vec<3, double>;

btVector3 bullet(Point p) { return {p.x, p.y, p.z}; }
btVector3 bullet(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
btVector3 in_space(const Vector& v) { return {v[0], v[1], v.size() == 3 ? v[2] : 0.0}; }

constexpr double margin = 0.02;  // over the smallest half side of a shape: Bullet's edge radius
constexpr int sweeps = 100;      // iterations of the solver over contacts and hinges

/// The triangles of a mesh, moved by -from.
std::unique_ptr<btTriangleMesh> triangles_of(const TriangleMesh& mesh, Point from) {
  auto all = std::make_unique<btTriangleMesh>();
  for (int t = 0; t < int(mesh.triangles.size()); ++t) {
    const auto c = mesh.corners(t);
    all->addTriangle(bullet(c[0] - from), bullet(c[1] - from), bullet(c[2] - from));
  }
  return all;
}

/// A collision shape and the memory that it refers to.
struct Collider {
  std::unique_ptr<btTriangleMesh> triangles;
  std::unique_ptr<btCollisionShape> shape;
  btTransform place = btTransform::getIdentity();
};

/// A box, ball or cylinder around the origin. Bullet's cylinder is along y; `turn` rotates it to
/// the region's axis.
std::unique_ptr<btCollisionShape> shape_of(const Scene::Region& r, bool flat, btQuaternion& turn) {
  std::unique_ptr<btCollisionShape> shape;
  double least = r.radius;
  if (r.shape == Shape::box) {
    btVector3 half = (in_space(r.max) - in_space(r.min)) / 2;
    if (flat) half.setZ(std::max(half.x(), half.y()));
    least = half[half.minAxis()];
    shape = std::make_unique<btBoxShape>(half);
  } else if (r.shape == Shape::sphere && !flat) {
    return std::make_unique<btSphereShape>(r.radius);
  } else if (r.shape == Shape::sphere) {
    shape = std::make_unique<btCylinderShapeZ>(btVector3(r.radius, r.radius, r.radius));
  } else {
    shape = std::make_unique<btCylinderShape>(btVector3(r.radius, r.length / 2, r.radius));
    least = std::min(r.radius, r.length / 2);
    turn = shortestArcQuat(btVector3(0, 1, 0), bullet(unit_of<3>(r.axis)));
  }
  shape->setMargin(margin * least);
  return shape;
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
    // the only part of a compound collider, and its place from the centre of mass at the start
    std::unique_ptr<btCollisionShape> part;
    btTransform part_place = btTransform::getIdentity();
  };

  const Scene& scene;
  const std::vector<BodyShape>& shapes;
  bool flat;
  std::vector<Body> bodies;
  std::vector<Collider> walls;

  Impl(const Scene& s, const std::vector<BodyShape>& b)
      : scene(s), shapes(b), flat(s.dimension() == 2) {
    for (std::size_t k = 0; k < s.body.size(); ++k) bodies.push_back(body(k));
    sides();
    for (const Scene::Wall& w : s.wall) wall(w);
  }

  Body body(std::size_t k) const {
    const Scene::Body& b = scene.body[k];
    const BodyShape& shape = shapes[k];
    Body out;
    const bool free = b.motion == BodyMotion::free;
    if (free) out.mass = shape.mass;
    out.free = freedoms_of(b, scene.dimension());
    if (!is_mesh(b) && b.side == Side::outside) out.collider.shape = shape_of(b, flat, out.turn);
    else mesh(b, shape, free, out);
    const bool other_axes =
        !flat && (!turns_freely(out.free) || (!b.inertia.empty() && !is_mesh(b)));
    if (free && (other_axes || !b.center_of_mass.empty())) compound(b, shape, out);
    const btMatrix3x3 inertia = inertia_of(shape, btMatrix3x3(out.turn).transpose());
    for (int d = 0; d < 3; ++d) out.inertia[d] = shape.density() * inertia[d][d];
    if (flat) out.inertia[0] = out.inertia[1] = out.inertia[2];  // it turns about z only
    return out;
  }
  /// Makes the collider a part of a compound: the axes of its shape are then no longer those of the
  /// inertia, or the centre of the shape is not that of mass.
  void compound(const Scene::Body& b, const BodyShape& shape, Body& out) const {
    out.part = std::move(out.collider.shape);
    out.part_place.setRotation(out.turn);
    if (!is_mesh(b)) out.part_place.setOrigin(bullet(shape.middle - shape.center));
    if (!flat) out.turn = principal_axes(inertia_of(shape)).turn;
    auto all = std::make_unique<btCompoundShape>(false);
    all->addChildShape(btTransform(out.turn).inverse() * out.part_place, out.part.get());
    out.collider.shape = std::move(all);
  }
  /// The axes and the inertia of a body in a step that begins with its rotation q.
  BodyAxes axes(std::size_t k, const btQuaternion& q) const {
    const Body& body = bodies[k];
    if (flat || body.mass == 0 || turns_freely(body.free)) return {body.turn, body.inertia};
    BodyAxes held = principal_axes(uncoupled(inertia_of(shapes[k], btMatrix3x3(q)), body.free));
    held.inertia *= shapes[k].density();
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
  /// The collider of a mesh or a tank. That of a free body is the convex hull, because Bullet
  /// cannot move concave meshes.
  void mesh(const Scene::Body& b, const BodyShape& shape, bool free, Body& out) const {
    const TriangleMesh m = collision_mesh(b);
    if (!free) {
      out.collider.triangles = triangles_of(m, shape.center);
      out.collider.shape =
          std::make_unique<btBvhTriangleMeshShape>(out.collider.triangles.get(), true);
      out.collider.shape->setMargin(0);
      return;
    }
    if (!flat) out.turn = principal_axes(inertia_of(shape)).turn;
    auto hull = std::make_unique<btConvexHullShape>();
    const btMatrix3x3 back = btMatrix3x3(out.turn).transpose();
    for (const Point& p : m.points) hull->addPoint(back * bullet(p - shape.center), false);
    hull->recalcLocalAabb();
    hull->optimizeConvexHull();
    hull->setMargin(1e-3 * shape.reach);
    out.collider.shape = std::move(hull);
  }

  void plane(const btVector3& normal, const btVector3& point) {
    walls.emplace_back();
    walls.back().shape = std::make_unique<btStaticPlaneShape>(normal, normal.dot(point));
  }
  void box_inside(const btVector3& low, const btVector3& high) {
    for (int d = 0; d < scene.dimension(); ++d) {
      btVector3 n(0, 0, 0);
      n[d] = 1;
      plane(n, low);
      plane(-n, high);
    }
  }
  void sides() {
    for (int side = 0; side < 2 * scene.dimension(); ++side) {
      if (scene.periodic(side / 2) || scene.side_method(side) == WallMethod::open) continue;
      btVector3 n(0, 0, 0);
      n[side / 2] = side % 2 ? -1 : 1;
      plane(n, in_space(side % 2 ? scene.domain.max : scene.domain.min));
    }
  }
  void wall(const Scene::Wall& w) {
    const bool tank = w.side == Side::inside;
    if (w.shape == Shape::plane) {
      btVector3 n = in_space(w.normal).normalized();
      plane(tank ? -n : n, in_space(w.point));
    } else if (is_mesh(w)) {
      walls.emplace_back();
      walls.back().triangles = triangles_of(w.loaded->distance.mesh(), {});
      walls.back().shape =
          std::make_unique<btBvhTriangleMeshShape>(walls.back().triangles.get(), true);
      walls.back().shape->setMargin(0);
    } else if (w.shape == Shape::box && tank) {
      box_inside(in_space(w.min), in_space(w.max));
    } else if (!tank && w.shape != Shape::points) {
      btQuaternion turn = btQuaternion::getIdentity();
      walls.emplace_back();
      walls.back().shape = shape_of(w, flat, turn);
      walls.back().place.setRotation(turn);
      walls.back().place.setOrigin(w.shape == Shape::box ? (in_space(w.min) + in_space(w.max)) / 2
                                                         : in_space(w.center));
    }
  }

  std::size_t named(const std::string& name) const {
    std::size_t k = 0;
    while (scene.body_name(k) != name) ++k;
    return k;
  }
};

namespace {

/// A Bullet world for one step. It is created for each step, so that contacts are no hidden state.
class Step {
 public:
  Step()
      : configuration_(few()),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity({0, 0, 0});
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = sweeps;
    info.m_splitImpulsePenetrationThreshold = 1e30;  // penetration never adds speed
    info.m_restitutionVelocityThreshold = 0.05;
  }
  ~Step() {
    for (auto& hinge : hinges_) world_.removeConstraint(hinge.get());
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  Step(const Step&) = delete;

  btRigidBody& add(double mass, btCollisionShape* shape, const btVector3& inertia,
                   const btTransform& place) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
    info.m_startWorldTransform = place;
    info.m_friction = info.m_restitution = 1;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    // Near bodies are no contact: Bullet would brake them before they touch, and they would not
    // bounce.
    bodies_.back()->setContactProcessingThreshold(0);
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
  }
  btHingeConstraint& hinge(std::unique_ptr<btHingeConstraint> h) {
    hinges_.push_back(std::move(h));
    world_.addConstraint(hinges_.back().get(), true);
    return *hinges_.back();
  }
  void advance(double dt) { world_.stepSimulation(dt, 0); }

 private:
  static btDefaultCollisionConstructionInfo few() {
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = 64;
    info.m_defaultMaxCollisionAlgorithmPoolSize = 64;
    return info;
  }
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btHingeConstraint>> hinges_;
};

}  // namespace

RigidWorld::RigidWorld(const Scene& scene, const std::vector<BodyShape>& shapes)
    : impl_(std::make_unique<Impl>(scene, shapes)) {}
RigidWorld::~RigidWorld() = default;

void RigidWorld::step(std::vector<BodyState>& states, std::span<const Load> loads, double dt) {
  Step step;
  const Impl& w = *impl_;
  std::vector<btRigidBody*> all;
  std::vector<btQuaternion> turns;  // from the axes of a body to Bullet's
  for (std::size_t k = 0; k < states.size(); ++k) {
    const BodyState& state = states[k];
    const Scene::Body& scene = w.scene.body[k];
    const auto& body = w.bodies[k];
    const auto& q = state.orientation;
    const btQuaternion turned(q[0], q[1], q[2], q[3]);
    const BodyAxes axes = w.axes(k, turned);
    turns.push_back(axes.turn);
    const btTransform place(turned * axes.turn, bullet(state.position));
    btRigidBody& b = step.add(body.mass, body.collider.shape.get(), axes.inertia, place);
    b.setFriction(scene.friction);
    b.setRestitution(scene.restitution);
    const btVector3 v = bullet(state.velocity), omega = bullet(state.angular_velocity);
    if (scene.motion == BodyMotion::moved) {
      // Bullet derives the velocity of a kinematic body from this place and the one of dt before.
      b.setCollisionFlags(b.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
      btTransform before;
      btTransformUtil::integrateTransform(place, -v, -omega, dt, before);
      b.setInterpolationWorldTransform(before);
    } else if (scene.motion == BodyMotion::free) {
      const auto& free = body.free;
      b.setLinearFactor(btVector3(free[0], free[1], free[2]));
      b.setAngularFactor(btVector3(free[3], free[4], free[5]));
      if (!w.flat && !turns_freely(free)) {
        b.setFlags(0);  // no gyroscopic torque by Bullet
        b.applyTorque(w.gyroscopic_torque(k, turned, omega));
      }
      b.setLinearVelocity(v);
      b.setAngularVelocity(omega);
      b.applyCentralForce(bullet(loads[k].force));
      b.applyTorque(bullet(loads[k].torque));
    }
    all.push_back(&b);
  }
  for (const Collider& wall : w.walls) step.add(0, wall.shape.get(), {0, 0, 0}, wall.place);
  btEmptyShape nothing;
  btRigidBody* world = nullptr;
  for (const Scene::Joint& joint : w.scene.joint) {
    // the hinge in the axes of each of the two bodies, from their initial positions
    const auto at = [&](std::size_t k, const btVector3& x) {
      const Point& c = w.shapes[k].center;
      return btMatrix3x3(turns[k]).transpose() * (x - bullet(c));
    };
    const auto along = [&](std::size_t k, const btVector3& a) {
      return btMatrix3x3(turns[k]).transpose() * a;
    };
    const std::size_t k = w.named(joint.body);
    const btVector3 x = in_space(joint.point),
                    a = w.flat ? btVector3(0, 0, 1) : in_space(joint.axis).normalized();
    std::unique_ptr<btHingeConstraint> hinge;
    if (joint.other.empty()) {
      if (!world) world = &step.add(0, &nothing, {0, 0, 0}, btTransform::getIdentity());
      hinge = std::make_unique<btHingeConstraint>(*all[k], *world, at(k, x), x, along(k, a), a);
    } else {
      const std::size_t j = w.named(joint.other);
      hinge = std::make_unique<btHingeConstraint>(*all[k], *all[j], at(k, x), at(j, x), along(k, a),
                                                  along(j, a));
    }
    btHingeConstraint& added = step.hinge(std::move(hinge));
    if (joint.motor_speed)
      added.enableAngularMotor(true, *joint.motor_speed, joint.motor_torque.value_or(0) * dt);
  }
  step.advance(dt);
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (w.scene.body[k].motion != BodyMotion::free) continue;
    const btTransform place = all[k]->getWorldTransform();
    btQuaternion q = place.getRotation() * turns[k].inverse();
    q.normalize();
    const auto& free = w.bodies[k].free;
    const auto move = [&](auto& to, const btVector3& by, std::size_t first) {
      for (std::size_t d = 0; d < 3; ++d)
        if (free[first + d]) to[d] = by[int(d)];
    };
    move(states[k].position, place.getOrigin(), 0);
    move(states[k].velocity, all[k]->getLinearVelocity(), 0);
    move(states[k].angular_velocity, all[k]->getAngularVelocity(), 3);
    if (free[3] || free[4] || free[5]) states[k].orientation = {q.x(), q.y(), q.z(), q.w()};
  }
}

#else

struct RigidWorld::Impl {};
RigidWorld::RigidWorld(const Scene&, const std::vector<BodyShape>&) {}
RigidWorld::~RigidWorld() = default;
void RigidWorld::step(std::vector<BodyState>&, std::span<const Load>, double) {}

#endif

}  // namespace freshet

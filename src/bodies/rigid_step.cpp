// SPDX-License-Identifier: MIT
#include "bodies/rigid_step.h"

#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>

#include <algorithm>
#include <mutex>
#include <numeric>

namespace freshet {
namespace {

constexpr double sunk = 1e-4;  // spacings: depth of a contact at rest, at which it is found again
// Small islands are solved exactly, at a cost of rows³: no stack creeps. Larger ones are solved by
// sweeps over their contacts, which end when velocities change by less than `settled`. A stack of
// thirty boxes in 3D has 360 rows; both ways then cost about 15 ms.
constexpr int most_exact = 360, sweeps = 1000, hinge_rows = 6;
constexpr double settled = 1e-7;  // m/s
// Yield of contacts, over the inverse mass of the heaviest body. More contacts than a body needs
// would else have no unique solution.
constexpr double yield = 1e-6;

btDefaultCollisionConstructionInfo small_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 64;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 64;
  return info;
}

/// The representative of an element of a set; links to it are shortened.
std::size_t find(std::vector<std::size_t>& parent, std::size_t k) {
  while (parent[k] != k) k = parent[k] = parent[parent[k]];
  return k;
}

/// Whether a body cannot move along an axis of the scene. Bullet's exact solver ignores it.
bool is_held(const btCollisionObject& object, bool flat) {
  const btVector3& factor = static_cast<const btRigidBody&>(object).getLinearFactor();
  return factor.x() == 0 || factor.y() == 0 || (factor.z() == 0 && !flat);
}

}  // namespace

RigidStep::RigidStep(const Scene& scene)
    : flat_(scene.dimension() == 2),
      configuration_(small_pools()),
      several_points_(&depth_),
      dispatcher_(&configuration_),
      contacts_(dispatcher_, scene) {
  // Shapes with flat faces touch in several points; boxes among themselves have an algorithm for
  // it.
  several_points_.m_numPerturbationIterations =
      several_points_.m_minimumPointsPerturbationThreshold = 4;
  constexpr int faces[] = {BOX_SHAPE_PROXYTYPE, TRIANGLE_SHAPE_PROXYTYPE,
                           CONVEX_HULL_SHAPE_PROXYTYPE, CYLINDER_SHAPE_PROXYTYPE};
  for (const int a : faces)
    for (const int b : faces)
      if (a != BOX_SHAPE_PROXYTYPE || b != BOX_SHAPE_PROXYTYPE)
        dispatcher_.registerCollisionCreateFunc(a, b, &several_points_);
  info_.m_numIterations = sweeps;
  info_.m_leastSquaresResidualThreshold = settled * settled;
  info_.m_linearSlop = sunk * scene.particles.spacing;
  info_.m_splitImpulsePenetrationThreshold = 1e30;  // penetration never adds speed
  info_.m_restitutionVelocityThreshold = 0.05;
  if (!flat_) info_.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
}

RigidStep::~RigidStep() {
  for (auto& h : hinges_) {
    h->getRigidBodyA().removeConstraintRef(h.get());
    h->getRigidBodyB().removeConstraintRef(h.get());
  }
}

btRigidBody& RigidStep::add(double mass, const btVector3& inertia, const btTransform& place,
                            const Collider* collider) {
  btCollisionShape* shape = collider ? collider->shape.get() : &nothing_;
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, inertia);
  info.m_startWorldTransform = place;
  info.m_friction = info.m_restitution = 1;
  bodies_.push_back(std::make_unique<btRigidBody>(info));
  btRigidBody& body = *bodies_.back();
  body.setActivationState(DISABLE_DEACTIVATION);
  // Near bodies are no contact: Bullet would brake them before they touch, and they would not
  // bounce.
  body.setContactProcessingThreshold(0);
  if (collider) contacts_.add(body, *collider);
  return body;
}

btHingeConstraint& RigidStep::hinge(std::unique_ptr<btHingeConstraint> h) {
  h->getRigidBodyA().addConstraintRef(h.get());
  h->getRigidBodyB().addConstraintRef(h.get());
  hinges_.push_back(std::move(h));
  return *hinges_.back();
}

/// The islands of the free bodies, in the order of their first bodies.
std::vector<RigidStep::Island> RigidStep::islands() {
  std::vector<std::size_t> parent(bodies_.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t k = 0; k < bodies_.size(); ++k) bodies_[k]->setUserIndex(int(k));
  const auto index = [](const btCollisionObject& b) { return std::size_t(b.getUserIndex()); };
  const auto unite = [&](const btCollisionObject& a, const btCollisionObject& b) {
    if (a.isStaticOrKinematicObject() || b.isStaticOrKinematicObject()) return;
    const std::size_t i = find(parent, index(a)), j = find(parent, index(b));
    parent[std::max(i, j)] = std::min(i, j);
  };
  const int contacts = dispatcher_.getNumManifolds();
  for (int k = 0; k < contacts; ++k) {
    const btPersistentManifold& m = *dispatcher_.getManifoldByIndexInternal(k);
    unite(*m.getBody0(), *m.getBody1());
  }
  for (const auto& h : hinges_) unite(h->getRigidBodyA(), h->getRigidBodyB());

  std::vector<Island> all(bodies_.size());
  const auto of = [&](const btCollisionObject& a, const btCollisionObject& b) -> Island& {
    return all[find(parent, index(a.isStaticOrKinematicObject() ? b : a))];
  };
  for (const auto& b : bodies_) {
    if (b->isStaticOrKinematicObject()) continue;
    Island& island = of(*b, *b);
    island.bodies.push_back(b.get());
    island.mass = std::max(island.mass, b->getMass());
  }
  for (int k = 0; k < contacts; ++k) {
    btPersistentManifold* m = dispatcher_.getManifoldByIndexInternal(k);
    if (m->getNumContacts()) of(*m->getBody0(), *m->getBody1()).contacts.push_back(m);
  }
  for (const auto& h : hinges_)
    of(h->getRigidBodyA(), h->getRigidBodyB()).hinges.push_back(h.get());
  std::erase_if(all, [](const Island& i) { return i.bodies.empty(); });
  return all;
}

/// The number of constraints of an island.
int RigidStep::rows(const Island& island) const {
  int points = 0;
  for (const btPersistentManifold* m : island.contacts) points += m->getNumContacts();
  const int per_point = info_.m_solverMode & SOLVER_USE_2_FRICTION_DIRECTIONS ? 3 : 2;
  return per_point * points + hinge_rows * int(island.hinges.size());
}

void RigidStep::solve(Island& i, double dt) {
  static std::mutex one_at_a_time;  // Bullet's exact solver has a global variable
  const auto by = [&](btSequentialImpulseConstraintSolver&& solver) {
    solver.solveGroup(i.bodies.data(), int(i.bodies.size()), i.contacts.data(),
                      int(i.contacts.size()), i.hinges.data(), int(i.hinges.size()), info_, nullptr,
                      &dispatcher_);
  };
  info_.m_timeStep = dt;
  info_.m_globalCfm = yield * dt / i.mass;
  const bool held = std::any_of(i.bodies.begin(), i.bodies.end(),
                                [this](const auto* b) { return is_held(*b, flat_); });
  if (const int n = rows(i); n == 0 || n > most_exact || held) {
    by(btSequentialImpulseConstraintSolver());
  } else {
    const std::lock_guard lock(one_at_a_time);
    btDantzigSolver exact;
    by(btMLCPSolver(&exact));
  }
}

/// Lets fast contacts rebound at once: one that is less deep than at rest would first be let in
/// that deep, which takes speed.
void RigidStep::let_bounce(btPersistentManifold& m) const {
  const auto* a = static_cast<const btRigidBody*>(m.getBody0());
  const auto* b = static_cast<const btRigidBody*>(m.getBody1());
  const auto velocity = [](const btRigidBody& body, const btVector3& x) {
    return body.getVelocityInLocalPoint(x - body.getWorldTransform().getOrigin());
  };
  for (int k = 0; k < m.getNumContacts(); ++k) {
    btManifoldPoint& p = m.getContactPoint(k);
    const btVector3 v =
        velocity(*a, p.getPositionWorldOnA()) - velocity(*b, p.getPositionWorldOnB());
    if (v.dot(p.m_normalWorldOnB) < -info_.m_restitutionVelocityThreshold)
      p.setDistance(std::min(p.getDistance(), -info_.m_linearSlop));
  }
}

void RigidStep::advance(double dt) {
  contacts_.find();
  for (int k = 0; k < dispatcher_.getNumManifolds(); ++k)
    let_bounce(*dispatcher_.getManifoldByIndexInternal(k));
  for (Island& island : islands()) solve(island, dt);
  for (const auto& body : bodies_) {
    if (body->isStaticOrKinematicObject()) continue;
    btTransform place;
    body->predictIntegratedTransform(dt, place);
    body->proceedToTransform(place);
  }
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// One step of rigid bodies with contacts and hinges. Needs Bullet.
#pragma once
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "bodies/contacts.h"

namespace freshet {

/// The objects of one step. They are created for each step, so that contacts are no hidden state.
class RigidStep {
 public:
  explicit RigidStep(const Scene& scene);
  RigidStep(const RigidStep&) = delete;
  ~RigidStep();

  /// Adds a body; a mass of 0 is that of a body that no force moves. A body without a collider
  /// touches nothing.
  btRigidBody& add(double mass, const btVector3& inertia, const btTransform& place,
                   const Collider* collider);
  /// Adds a hinge. Bodies on a common hinge do not collide.
  btHingeConstraint& hinge(std::unique_ptr<btHingeConstraint> hinge);
  /// Moves the bodies by dt [s].
  void advance(double dt);

 private:
  /// Bodies that are connected by contacts or hinges. They are solved apart from others.
  struct Island {
    std::vector<btCollisionObject*> bodies;
    std::vector<btPersistentManifold*> contacts;
    std::vector<btTypedConstraint*> hinges;
    double mass = 0;  // of the heaviest body
  };
  std::vector<Island> islands();
  void let_bounce(btPersistentManifold& contact) const;
  void solve(Island& island, double dt);
  int rows(const Island& island) const;

  bool flat_;
  btDefaultCollisionConfiguration configuration_;
  btGjkEpaPenetrationDepthSolver depth_;
  btConvexConvexAlgorithm::CreateFunc several_points_;
  btCollisionDispatcher dispatcher_;
  btContactSolverInfo info_;
  btEmptyShape nothing_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btHingeConstraint>> hinges_;
  Contacts contacts_;
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// The contacts of one step, also those across periodic ends of the domain. Needs Bullet.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <vector>

#include "bodies/colliders.h"

namespace freshet {

/// Finds all contacts anew in each step, in all points in which shapes touch. Nothing is remembered
/// between steps. The contacts last as long as this.
class Contacts {
 public:
  Contacts(btCollisionDispatcher& dispatcher, const Scene& scene)
      : dispatcher_(dispatcher), periods_(periods_of(scene)), flat_(scene.dimension() == 2) {}
  Contacts(const Contacts&) = delete;
  ~Contacts();

  /// Adds a body or wall at its place. Both arguments must outlive this.
  void add(btRigidBody& body, const Collider& collider);
  /// Finds the contacts of all free bodies with each other and with all other objects.
  void find();

 private:
  struct Object {
    btRigidBody* body;
    const Collider* collider;
    btVector3 low, high;
  };
  /// Consecutive numbers of periods. There are none if count is 0 or negative.
  struct Shifts {
    double first = 0;
    int count = 1;
  };
  Shifts shifts(const Object& free, const Object& other, int axis) const;
  void find_pairs();
  void find(const Object& free, const Object& other);
  void touch(btRigidBody& free, btRigidBody& other, const btVector3& shift);
  void touch_plane(const btCollisionObjectWrapper& free, const btCollisionObjectWrapper& plane);

  btCollisionDispatcher& dispatcher_;
  btVector3 periods_;
  bool flat_;
  std::vector<Object> objects_;
  std::vector<btCollisionAlgorithm*> algorithms_;
  std::vector<btPersistentManifold*> manifolds_;
};

}  // namespace freshet

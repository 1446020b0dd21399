// SPDX-License-Identifier: MIT
/// Bullet's collision shapes of bodies and walls. Needs Bullet.
#pragma once
#include <btBulletDynamicsCommon.h>

#include <array>
#include <memory>
#include <vector>

#include "scene/model/body_shape.h"
#include "scene/model/solid_of.h"

namespace freshet {

inline btVector3 bullet(Vec<3, double> p) { return {p.x, p.y, p.z}; }
inline btVector3 bullet(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
inline btVector3 bullet(const Vector& v) { return {v[0], v[1], v.size() == 3 ? v[2] : 0.0}; }
inline btMatrix3x3 bullet(const double (&m)[3][3]) {
  return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

/// The lengths of a domain along its periodic axes [m], 0 along the others.
btVector3 periods_of(const Scene& scene);

/// A collision shape and the memory that it refers to.
struct Collider {
  std::unique_ptr<btTriangleMesh> triangles;
  std::unique_ptr<btCollisionShape> part;  // the only one of a compound shape
  std::unique_ptr<btCollisionShape> shape;
  btTransform place = btTransform::getIdentity();
  /// Whether the shape stands for all its periodic images along an axis: a plane, or a box that
  /// spans the period. Only the image of a body that is nearest to `middle` collides with it.
  std::array<bool, 3> endless{};
  btVector3 middle{0, 0, 0};  // from the origin of its place
};

/// Whether a free body collides as its convex hull, whose points are relative to its centre of
/// mass.
inline bool is_hull(const Scene::Body& body) { return is_mesh(body) || body.side == Side::inside; }

/// The shape of a body about its centre of mass. `turn` receives the rotation from Bullet's axes,
/// in which the inertia is diagonal. A mesh or tank that is free becomes its convex hull, because
/// Bullet cannot move concave meshes.
Collider body_collider(const Scene& scene, std::size_t k, const BodyShape& shape,
                       btQuaternion& turn);

/// The sides of the domain and the walls that stop bodies.
std::vector<Collider> wall_colliders(const Scene& scene);

}  // namespace freshet

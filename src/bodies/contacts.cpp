// SPDX-License-Identifier: MIT
#include "bodies/contacts.h"

#include <cmath>

namespace freshet {
namespace {

constexpr double most_images = 1000;  // along an axis; more are those of a body beyond all bounds

bool is_plane(const btRigidBody& b) {
  return b.getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
}

/// The shape of an object and its place; of a compound, those of its only part.
struct Part {
  const btCollisionShape* shape;
  btTransform place;
};
Part part_of(const btRigidBody& b) {
  const btCollisionShape* shape = b.getCollisionShape();
  if (!shape->isCompound()) return {shape, b.getWorldTransform()};
  const auto& all = static_cast<const btCompoundShape&>(*shape);
  return {all.getChildShape(0), b.getWorldTransform() * all.getChildTransform(0)};
}

/// Points of the rims of a cylinder that can be its deepest against a plane with this normal: on
/// its side the lowest of both rims, on its end four of the lower rim.
void add_rims(const btCylinderShape& c, const btTransform& place, const btVector3& normal,
              std::vector<btVector3>& points) {
  const double radius = c.getRadius(), half = c.getHalfExtentsWithMargin().y();
  btVector3 axis = place.getBasis().getColumn(1), u, v;
  if (axis.dot(normal) > 0) axis = -axis;
  btPlaneSpace1(axis, u, v);
  if (const btVector3 low = axis * axis.dot(normal) - normal; low.length() > 1e-6) {
    u = low.normalized();
    v = axis.cross(u);
  }
  const btVector3 lower = place.getOrigin() + half * axis, upper = place.getOrigin() - half * axis;
  points.insert(points.end(), {lower + radius * u, upper + radius * u, lower - radius * u,
                               lower + radius * v, lower - radius * v});
}

/// The points of a convex shape that can be its deepest against a plane with this normal.
std::vector<btVector3> corners_of(const btConvexShape& shape, const btTransform& place,
                                  const btVector3& normal) {
  std::vector<btVector3> points;
  if (shape.getShapeType() == CYLINDER_SHAPE_PROXYTYPE) {
    add_rims(static_cast<const btCylinderShape&>(shape), place, normal, points);
  } else if (shape.isPolyhedral()) {
    const auto& p = static_cast<const btPolyhedralConvexShape&>(shape);
    // the corners of a box include its margin
    const double margin = shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? 0 : shape.getMargin();
    for (int k = 0; k < p.getNumVertices(); ++k) {
      btVector3 corner;
      p.getVertex(k, corner);
      points.push_back(place(corner) - margin * normal);
    }
  } else {
    points.push_back(place(shape.localGetSupportingVertex(-(normal * place.getBasis()))));
  }
  return points;
}

/// Moves the points of contacts with the image of a body to the body itself, as Bullet's solver
/// takes lever arms from them.
void move_points(btPersistentManifold& m, const btRigidBody& other, const btVector3& by) {
  for (int k = 0; k < m.getNumContacts(); ++k) {
    btManifoldPoint& p = m.getContactPoint(k);
    (m.getBody0() == &other ? p.m_positionWorldOnA : p.m_positionWorldOnB) += by;
  }
}

/// Drops one of two points that differ in z only. In 2D they are the same contact, and twins have
/// no unique solution.
void drop_twins(btPersistentManifold& m) {
  const auto twins = [&](const btVector3& a, const btVector3& b) {
    return a.z() < 0 && b.z() > 0 &&
           std::hypot(a.x() - b.x(), a.y() - b.y()) < m.getContactBreakingThreshold();
  };
  for (int k = m.getNumContacts() - 1; k >= 0; --k)
    for (int j = 0; j < m.getNumContacts(); ++j)
      if (twins(m.getContactPoint(k).m_positionWorldOnA, m.getContactPoint(j).m_positionWorldOnA)) {
        m.removeContactPoint(k);
        break;
      }
}

}  // namespace

Contacts::~Contacts() {
  for (btCollisionAlgorithm* algorithm : algorithms_) {
    algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm);
  }
  for (btPersistentManifold* manifold : manifolds_) dispatcher_.releaseManifold(manifold);
}

void Contacts::add(btRigidBody& body, const Collider& collider) {
  Object o{&body, &collider, {}, {}};
  body.getAabb(o.low, o.high);
  objects_.push_back(o);
}

void Contacts::find() {
  find_pairs();
  for (int k = 0; flat_ && k < dispatcher_.getNumManifolds(); ++k)
    drop_twins(*dispatcher_.getManifoldByIndexInternal(k));
}

void Contacts::find_pairs() {
  const auto is_free = [](const Object& o) { return !o.body->isStaticOrKinematicObject(); };
  for (std::size_t i = 0; i < objects_.size(); ++i)
    for (std::size_t j = i + 1; j < objects_.size(); ++j) {
      if (is_free(objects_[i])) find(objects_[i], objects_[j]);
      else if (is_free(objects_[j])) find(objects_[j], objects_[i]);
    }
}

/// The numbers of periods by which the other object must be shifted along an axis to meet the free
/// body.
Contacts::Shifts Contacts::shifts(const Object& free, const Object& other, int axis) const {
  const double period = periods_[axis];
  if (period == 0)
    return {0, other.low[axis] <= free.high[axis] && free.low[axis] <= other.high[axis]};
  if (other.collider->endless[std::size_t(axis)]) {
    const double middle =
        other.body->getWorldTransform().getOrigin()[axis] + other.collider->middle[axis];
    const double apart = free.body->getWorldTransform().getOrigin()[axis] - middle;
    return {std::floor(apart / period + 0.5), 1};
  }
  const double first = std::ceil((free.low[axis] - other.high[axis]) / period),
               last = std::floor((free.high[axis] - other.low[axis]) / period);
  return {first, last - first < most_images ? int(last - first) + 1 : 0};
}

void Contacts::find(const Object& free, const Object& other) {
  Shifts s[3];
  for (int d = 0; d < 3; ++d)
    if (s[d] = shifts(free, other, d); s[d].count <= 0) return;
  if (!dispatcher_.needsCollision(free.body, other.body)) return;
  for (int x = 0; x < s[0].count; ++x)
    for (int y = 0; y < s[1].count; ++y)
      for (int z = 0; z < s[2].count; ++z)
        touch(*free.body, *other.body,
              btVector3(s[0].first + x, s[1].first + y, s[2].first + z) * periods_);
}

/// Finds the contacts of a free body with an object that is shifted.
void Contacts::touch(btRigidBody& free, btRigidBody& other, const btVector3& shift) {
  const Part of_free = part_of(free);
  Part of_other = part_of(other);
  of_other.place.getOrigin() += shift;
  const btCollisionObjectWrapper a(nullptr, of_free.shape, &free, of_free.place, -1, -1),
      b(nullptr, of_other.shape, &other, of_other.place, -1, -1);
  if (is_plane(other)) return touch_plane(a, b);
  algorithms_.push_back(dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS));
  btManifoldResult result(&a, &b);
  btDispatcherInfo info;
  info.m_enableSatConvex = of_other.shape->isConcave();
  algorithms_.back()->processCollision(&a, &b, info, &result);
  if (btPersistentManifold* m = result.getPersistentManifold()) move_points(*m, other, -shift);
}

/// Finds all points of a convex shape behind a plane. Bullet's own algorithm finds one, over which
/// a box rocks.
void Contacts::touch_plane(const btCollisionObjectWrapper& free,
                           const btCollisionObjectWrapper& other) {
  const auto& plane = static_cast<const btStaticPlaneShape&>(*other.getCollisionShape());
  const auto& shape = static_cast<const btConvexShape&>(*free.getCollisionShape());
  const btVector3 &normal = plane.getPlaneNormal(), &origin = other.getWorldTransform().getOrigin();
  btManifoldResult result(&free, &other);
  for (const btVector3& x : corners_of(shape, free.getWorldTransform(), normal)) {
    const double distance = normal.dot(x - origin) - plane.getPlaneConstant();
    if (distance > 0) continue;
    if (!result.getPersistentManifold()) {
      manifolds_.push_back(
          dispatcher_.getNewManifold(free.getCollisionObject(), other.getCollisionObject()));
      result.setPersistentManifold(manifolds_.back());
    }
    result.addContactPoint(normal, x - distance * normal, distance);
  }
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "bodies/colliders.h"

#include <algorithm>

#include "bodies/body_axes.h"
#include "scene/model/body_mesh.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

constexpr double margin = 0.02;  // over the smallest half side of a shape: Bullet's edge radius
constexpr int most_corners =
    32;  // of a hull whose faces are laid on triangles, at a cost of edges²

btVector3 middle_of(const Vector& low, const Vector& high) {
  return (bullet(low) + bullet(high)) / 2;
}

/// The triangles of a mesh, moved by -from.
void set_triangles(Collider& c, const TriangleMesh& mesh, Vec<3, double> from) {
  c.triangles = std::make_unique<btTriangleMesh>();
  for (int t = 0; t < int(mesh.triangles.size()); ++t) {
    const auto corner = mesh.corners(t);
    c.triangles->addTriangle(bullet(corner[0] - from), bullet(corner[1] - from),
                             bullet(corner[2] - from));
  }
  c.shape = std::make_unique<btBvhTriangleMeshShape>(c.triangles.get(), true);
  c.shape->setMargin(0);
}

/// A box, ball or cylinder around the origin. Bullet's cylinder is along y; `turn` rotates it to
/// the region's axis.
std::unique_ptr<btConvexInternalShape> shape_of(const Scene::Region& r, bool flat,
                                                btQuaternion& turn) {
  std::unique_ptr<btConvexInternalShape> shape;
  double smallest = r.radius;
  if (r.shape == Shape::box) {
    btVector3 half = (bullet(r.max) - bullet(r.min)) / 2;
    if (flat) half.setZ(std::max(half.x(), half.y()));
    smallest = half[half.minAxis()];
    auto box = std::make_unique<btBoxShape>(half);
    box->initializePolyhedralFeatures();  // its faces, to be laid on triangles
    shape = std::move(box);
  } else if (r.shape == Shape::sphere) {
    return std::make_unique<btSphereShape>(r.radius);  // in the plane of a 2D scene it is a disc
  } else {
    shape = std::make_unique<btCylinderShape>(btVector3(r.radius, r.length / 2, r.radius));
    smallest = std::min(r.radius, r.length / 2);
    turn = shortestArcQuat(btVector3(0, 1, 0), bullet(unit_of<3>(r.axis)));
  }
  shape->setMargin(margin * smallest);
  return shape;
}

/// Makes a box longer by a period at both ends of each axis on which it spans the domain. A body
/// that slides over a seam would else meet the edges of two boxes.
Scene::Region without_seams(const Scene& s, Scene::Region box, Collider& c) {
  for (int d = 0; d < s.dimension(); ++d) {
    const auto k = std::size_t(d);
    const double period = periods_of(s)[d];
    c.endless[k] = period > 0 && box.max[k] - box.min[k] >= period * (1 - 1e-9);
    if (c.endless[k]) box.min[k] -= period, box.max[k] += period;
  }
  return box;
}

/// A fixed body, or a moved one that keeps its orientation.
bool never_turns(const Scene::Body& b) {
  return b.motion == BodyMotion::fixed ||
         (b.motion == BodyMotion::moved && b.angle.empty() && b.path.empty() &&
          std::all_of(b.key.begin(), b.key.end(), [](const auto& k) { return k.angle == 0; }));
}

void set_hull(Collider& c, const TriangleMesh& mesh, const BodyShape& shape,
              const btQuaternion& turn) {
  auto hull = std::make_unique<btConvexHullShape>();
  const btMatrix3x3 back = btMatrix3x3(turn).transpose();
  for (const auto& p : mesh.points) hull->addPoint(back * bullet(p - shape.center), false);
  hull->recalcLocalAabb();
  hull->optimizeConvexHull();
  hull->setMargin(1e-3 * shape.reach);
  if (hull->getNumVertices() <= most_corners) hull->initializePolyhedralFeatures();
  c.shape = std::move(hull);
}

class WallColliders {
 public:
  explicit WallColliders(const Scene& s) : scene_(s) {}

  void sides() {
    const btVector3 middle = middle_of(scene_.domain.min, scene_.domain.max);
    for (int side = 0; side < 2 * scene_.dimension(); ++side) {
      if (scene_.periodic(side / 2) || scene_.is_open(side)) continue;
      btVector3 n(0, 0, 0);
      n[side / 2] = side % 2 ? -1 : 1;
      plane(n, bullet(side % 2 ? scene_.domain.max : scene_.domain.min), middle);
    }
  }
  void wall(const Scene::Wall& w) {
    const bool tank = w.side == Side::inside;
    if (w.shape == Shape::plane) {
      const btVector3 n = bullet(w.normal).normalized();
      plane(tank ? -n : n, bullet(w.point), middle_of(scene_.domain.min, scene_.domain.max));
    } else if (is_mesh(w)) {
      set_triangles(all_.emplace_back(), w.loaded->distance.mesh(), {});
    } else if (w.shape == Shape::box && tank) {
      box_inside(w);
    } else if (!tank && w.shape != Shape::points) {
      solid(w);
    }
  }
  std::vector<Collider> take() { return std::move(all_); }

 private:
  void plane(const btVector3& normal, const btVector3& point, const btVector3& middle) {
    Collider& c = all_.emplace_back();
    c.shape = std::make_unique<btStaticPlaneShape>(normal, normal.dot(point));
    c.endless = {true, true, true};
    c.middle = middle;
  }
  /// The planes of a tank.
  void box_inside(const Scene::Wall& w) {
    const btVector3 low = bullet(w.min), high = bullet(w.max);
    for (int d = 0; d < scene_.dimension(); ++d) {
      btVector3 n(0, 0, 0);
      n[d] = 1;
      plane(n, low, (low + high) / 2);
      plane(-n, high, (low + high) / 2);
    }
  }
  void solid(const Scene::Wall& w) {
    Collider& c = all_.emplace_back();
    btQuaternion turn = btQuaternion::getIdentity();
    Scene::Region region = w;
    if (w.shape == Shape::box) region = without_seams(scene_, region, c);
    c.shape = shape_of(region, scene_.dimension() == 2, turn);
    c.place.setRotation(turn);
    c.place.setOrigin(w.shape == Shape::box ? middle_of(w.min, w.max) : bullet(w.center));
  }

  const Scene& scene_;
  std::vector<Collider> all_;
};

}  // namespace

btVector3 periods_of(const Scene& s) {
  btVector3 periods(0, 0, 0);
  for (int d = 0; d < s.dimension(); ++d)
    if (s.periodic(d)) periods[d] = s.domain.max[std::size_t(d)] - s.domain.min[std::size_t(d)];
  return periods;
}

Collider body_collider(const Scene& s, std::size_t k, const BodyShape& shape, btQuaternion& turn) {
  const Scene::Body& b = s.body[k];
  Collider c;
  const bool flat = s.dimension() == 2;
  if (!is_hull(b)) {
    Scene::Region region = b;
    if (b.shape == Shape::box && never_turns(b)) region = without_seams(s, region, c);
    c.shape = shape_of(region, flat, turn);
  } else if (b.motion == BodyMotion::free) {
    if (!flat) turn = principal_axes(inertia_of(shape)).turn;
    set_hull(c, collision_mesh(b), shape, turn);
  } else {
    set_triangles(c, collision_mesh(b), shape.center);
  }
  return c;
}

std::vector<Collider> wall_colliders(const Scene& s) {
  WallColliders walls(s);
  walls.sides();
  for (const Scene::Wall& w : s.wall) walls.wall(w);
  return walls.take();
}

}  // namespace freshet

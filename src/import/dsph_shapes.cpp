// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "import/dualsphysics.h"
#include "import/mesh_solid.h"
#include "mesh/mesh_distance.h"

namespace freshet {
namespace {

using ShapePoint = Vec<3, double>;

double axis_of(const ShapePoint& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

/// A box in its own coordinates: its inside, or the sides that are drawn.
bool is_in_box(const DsphShape& s, const ShapePoint& q, double beyond) {
  for (int k = 0; k < 3; ++k)
    if (axis_of(q, k) <= axis_of(s.low, k) - beyond || axis_of(q, k) > axis_of(s.high, k) + beyond)
      return false;
  return true;
}

bool is_on_sides(const DsphShape& s, const ShapePoint& q, double half) {
  for (int k = 0; k < 3; ++k) {
    const double x = axis_of(q, k), low = axis_of(s.low, k), high = axis_of(s.high, k);
    if ((s.sides >> (2 * k) & 1u) && x > low - half && x <= low + half) return true;
    if ((s.sides >> (2 * k + 1) & 1u) && x > high - half && x <= high + half) return true;
  }
  return false;
}

/// Whether a ray along x crosses the profile an odd number of times.
bool is_in_profile(const std::vector<ShapePoint>& points, const ShapePoint& p) {
  bool inside = false;
  for (std::size_t k = 0, n = points.size(); k < n; ++k) {
    const ShapePoint &a = points[k], &b = points[(k + 1) % n];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

/// Whether a place is so near to a line that lines of places cannot pass between.
bool is_on_line(const ShapePoint& a, const ShapePoint& b, const ShapePoint& p, double half) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / length,
               across = ((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
  const double reach = half * (std::abs(dx) + std::abs(dy)) / length * (1 + 1e-6);
  return along >= -half && along <= length + half && std::abs(across) <= reach;
}

bool is_on_profile(const DsphShape& s, const ShapePoint& p, double half) {
  if (p.z < s.z_low - half || p.z > s.z_high + half) return false;
  for (std::size_t k = 0; k < s.points.size(); ++k)
    if (s.shown[k] && is_on_line(s.points[k], s.points[(k + 1) % s.points.size()], p, half))
      return true;
  return s.solid && is_in_profile(s.points, p);
}

bool is_in_cylinder(const DsphShape& s, const ShapePoint& p, double beyond) {
  const ShapePoint axis = s.high - s.low, from = p - s.low;
  const double length = norm(axis);
  if (!(length > 0)) return false;
  const double along = dot(from, axis) / length;
  return along >= -beyond && along <= length + beyond &&
         norm2(from) - along * along <= (s.radius + beyond) * (s.radius + beyond);
}

Bounds bounds_of_shape(const DsphShape& s) {
  Bounds bounds;
  const ShapePoint r{s.radius, s.radius, s.radius};
  if (s.kind == DsphShape::Kind::box)
    for (int k = 0; k < 8; ++k)
      bounds.add(s.frame(ShapePoint{k & 1 ? s.high.x : s.low.x, k & 2 ? s.high.y : s.low.y,
                                    k & 4 ? s.high.z : s.low.z}));
  else if (s.kind == DsphShape::Kind::profile)
    for (const ShapePoint& p : s.points)
      for (const double z : {s.z_low, s.z_high}) bounds.add(ShapePoint{p.x, p.y, z});
  else
    for (const ShapePoint& p : {s.low, s.kind == DsphShape::Kind::cylinder ? s.high : s.low}) {
      bounds.add(p - r);
      bounds.add(p + r);
    }
  return bounds;
}

/// The surface of a mesh: triangles in 3D, its section in 2D.
void mark_mesh(const DsphShape& s, DsphWorld& world) {
  TriangleMesh mesh = read_mesh(world.from / s.file);
  for (ShapePoint& p : mesh.points) p = s.frame(from_dsph(p));
  DsphLattice& lattice = *world.lattice;
  const double half = world.dp / 2;
  if (world.flat()) {
    for (ShapePoint& p : mesh.points) p.z -= world.plane_z;
    for (const auto& loop : section_of_mesh(mesh, {}, half)) {
      DsphShape part{s.element, DsphShape::Kind::profile, s.mark, {}};
      part.points = loop;
      part.shown.assign(loop.size(), true);
      part.z_low = -1e9;
      part.z_high = 1e9;
      mark_dsph_shape(part, world);
    }
    return;
  }
  Bounds bounds;
  for (const ShapePoint& p : mesh.points) bounds.add(p);
  const MeshDistance distance(std::move(mesh));
  lattice.each_in(bounds, [&](const DsphLattice::Index& i) {
    if (distance.nearest(lattice.place(i)).distance <= 1.8 * half) lattice.at(i) = s.mark;
  });
}

}  // namespace

bool is_in_dsph_shape(const DsphShape& s, const ShapePoint& p, double beyond) {
  switch (s.kind) {
    case DsphShape::Kind::box:
      return is_in_box(s, s.frame.inverse(p), beyond);
    case DsphShape::Kind::sphere:
      return norm(p - s.low) <= s.radius + beyond;
    case DsphShape::Kind::cylinder:
      return is_in_cylinder(s, p, beyond);
    case DsphShape::Kind::profile:
      return p.z >= s.z_low - beyond && p.z <= s.z_high + beyond && is_in_profile(s.points, p);
    case DsphShape::Kind::mesh:
      break;
  }
  return false;
}

void mark_dsph_shape(const DsphShape& s, DsphWorld& world) {
  if (s.kind == DsphShape::Kind::mesh) {
    mark_mesh(s, world);
    return;
  }
  DsphLattice& lattice = *world.lattice;
  const double half = world.dp / 2, round = 1e-6 * world.dp;
  lattice.each_in(bounds_of_shape(s), [&](const DsphLattice::Index& i) {
    const ShapePoint p = lattice.place(i);
    bool drawn = false;
    if (s.kind == DsphShape::Kind::box) {
      // Half-way between two places the upper one is drawn, as in DsphLattice::nearest.
      const ShapePoint q = s.frame.inverse(p) - round * ShapePoint{1, 1, 1};
      drawn = is_in_box(s, q, half) && (s.solid || is_on_sides(s, q, half));
    } else if (s.kind == DsphShape::Kind::profile) drawn = is_on_profile(s, p, world.dp / 2);
    else drawn = is_in_dsph_shape(s, p, round);
    if (drawn) lattice.at(i) = s.mark;
  });
}

double DsphWorld::water_height() const {
  const Bounds water = lattice->extent(true);
  return water.empty() ? 0 : water.size().y;
}

bool DsphWorld::holds_fluid(const DsphShape& shape) const {
  bool holds = false;
  lattice->each_in(bounds_of_shape(shape), [&](const DsphLattice::Index& i) {
    holds = holds || (lattice->at(i) > 0 && is_in_dsph_shape(shape, lattice->place(i), -dp / 4));
  });
  return holds;
}

}  // namespace freshet

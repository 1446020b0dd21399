// SPDX-License-Identifier: MIT
#include "view/shapes.h"

#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "render/bodies.h"
#include "scene/model/body_mesh.h"
#include "scene/model/body_shape.h"
#include "scene/model/outline.h"
#include "scene/sample/point_cloud.h"
#include "view/solid_edges.h"

namespace freshet::view {
namespace {

constexpr Tint domain_edge{0.50f, 0.56f, 0.62f, 1}, wall_fill{0.62f, 0.64f, 0.66f, 1},
    wall_edge{0.42f, 0.46f, 0.50f, 1}, probe_edge{0.93f, 0.45f, 0.13f, 1};

Point in_space(const Vector& v) { return {v[0], v[1], v.size() == 3 ? v[2] : 0.0}; }

void add_line(Part& part, Point a, Point b) {
  for (const Point& p : {a, b})
    for (const double x : {p.x, p.y, p.z}) part.lines.push_back(float(x));
}

void add_corner(Part& part, Point p, Point normal) {
  for (const double x : {p.x, p.y, p.z, normal.x, normal.y, normal.z})
    part.triangles.push_back(float(x));
}

Part domain_of(const Scene& scene) {
  Part part;
  part.edge = domain_edge;
  const Point low = in_space(scene.domain.min), high = in_space(scene.domain.max);
  const auto corner = [&](int k) {
    return Point{k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z};
  };
  const int corners = scene.dimension() == 3 ? 8 : 4;
  for (int k = 0; k < corners; ++k)
    for (int axis = 1; axis < corners; axis *= 2)
      if (!(k & axis)) add_line(part, corner(k), corner(k | axis));
  return part;
}

/// The polygon where a plane cuts the box of the domain; in 2D its two ends.
std::vector<Point> section_of(const Scene& scene, Point point, Point normal) {
  const Part box = domain_of(scene);
  std::vector<Point> cuts;
  for (std::size_t k = 0; k + 6 <= box.lines.size(); k += 6) {
    const float* l = box.lines.data() + k;
    const Point a{l[0], l[1], l[2]}, b{l[3], l[4], l[5]};
    const double from = dot(a - point, normal), to = dot(b - point, normal);
    if ((from < 0) != (to < 0)) cuts.push_back(a + from / (from - to) * (b - a));
  }
  if (cuts.size() < 3) return cuts;
  Point middle{0, 0, 0};
  for (const Point& c : cuts) middle += c / double(cuts.size());
  const Point u = (cuts[0] - middle) / norm(cuts[0] - middle), v = cross(normal, u);
  std::sort(cuts.begin(), cuts.end(), [&](Point a, Point b) {
    return std::atan2(dot(a - middle, v), dot(a - middle, u)) <
           std::atan2(dot(b - middle, v), dot(b - middle, u));
  });
  return cuts;
}

void add_plane(Part& part, const Scene& scene, const Scene::Region& region) {
  const Point along = in_space(region.normal), normal = along / norm(along);
  const std::vector<Point> cut = section_of(scene, in_space(region.point), normal);
  for (std::size_t k = 0; k < cut.size(); ++k) {
    if (cut.size() == 2 && k == 1) break;
    add_line(part, cut[k], cut[(k + 1) % cut.size()]);
    if (k < 2) continue;
    for (const Point& p : {cut[0], cut[k - 1], cut[k]}) add_corner(part, p, normal);
  }
}

void add_outline(Part& part, const Scene::Region& region, double z, bool filled) {
  const Outline outline = outline_of(region);
  const auto at = [&](std::size_t k) { return Point{outline[k].x, outline[k].y, z}; };
  for (std::size_t k = 0; k < outline.size(); ++k)
    add_line(part, at(k), at((k + 1) % outline.size()));
  if (!filled) return;
  for (const TriangleMesh::Triangle& t : triangulate(outline))
    for (const int k : t) add_corner(part, at(std::size_t(k)), {0, 0, 1});
}

void add_surface(Part& part, const Scene::Region& region, bool filled) {
  Scene::Body body;
  static_cast<Scene::Region&>(body) = region;
  const TriangleMesh mesh = body_mesh(body);
  for (const auto& [a, b] : sharp_edges(mesh)) add_line(part, a, b);
  if (!filled) return;
  const std::vector<std::array<Point, 3>> normals = smooth_normals(mesh);
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const auto corners = mesh.corners(int(t));
    for (std::size_t k = 0; k < 3; ++k) add_corner(part, corners[k], normals[t][k]);
  }
}

/// The points of a file; none if it cannot be read, as after a run whose inputs are gone.
void add_points(Part& part, const Scene& scene, const Scene::Region& region) {
  const auto D = std::size_t(scene.dimension());
  PointCloud cloud;
  try {
    cloud = region_points(region, int(D));
  } catch (const Error&) {
    return;
  }
  for (std::size_t i = 0; i + D <= cloud.x.size(); i += D)
    for (std::size_t d = 0; d < 4; ++d) part.points.push_back(d < D ? float(cloud.x[i + d]) : 0);
}

/// A wall or body. Tanks, which hold the fluid, are edges only.
void add_region(Part& part, const Scene& scene, const Scene::Region& region) {
  const bool solid = region.side == Side::outside;
  if (region.shape == Shape::plane) return add_plane(part, scene, region);
  if (region.shape == Shape::points) return add_points(part, scene, region);
  if (scene.dimension() == 3) return add_surface(part, region, solid);
  add_outline(part, region, scene.particles.spacing, solid);
}

/// A cross of three lines.
void add_cross(Part& part, Point p, double size, int dimension) {
  for (int d = 0; d < dimension; ++d) {
    Point arm{0, 0, 0};
    component(arm, d) = size;
    add_line(part, p - arm, p + arm);
  }
}

/// The rectangle across an axis between two opposite corners; in 2D, and for corners that differ
/// along every axis, the line between them.
void add_rectangle(Part& part, Point a, Point b, int dimension) {
  int across = -1;
  Point diagonal = b - a;
  for (int k = 0; k < dimension; ++k)
    if (component(diagonal, k) == 0) across = k;
  if (dimension == 2 || across < 0) return add_line(part, a, b);
  const int first = (across + 1) % 3;
  Point c = a, d = b;
  component(c, first) = component(b, first);
  component(d, first) = component(a, first);
  add_line(part, a, c);
  add_line(part, c, b);
  add_line(part, b, d);
  add_line(part, d, a);
}

Part probe_of(const Scene& scene, const Scene::Probe& probe) {
  Part part;
  part.kind = Part::Kind::probe;
  part.edge = probe_edge;
  const int D = scene.dimension();
  if (probe.kind == ProbeKind::point) {
    add_cross(part, in_space(probe.at), 2 * scene.particles.spacing, D);
  } else if (probe.kind == ProbeKind::plane || probe.kind == ProbeKind::wall) {
    add_rectangle(part, in_space(probe.from), in_space(probe.to), D);
  } else {
    add_line(part, in_space(probe.from), in_space(probe.to));
  }
  return part;
}

}  // namespace

std::vector<Part> parts_of(const Scene& scene) {
  std::vector<Part> parts{domain_of(scene)};
  for (const Scene::Wall& wall : scene.wall) {
    Part part;
    part.kind = Part::Kind::wall;
    part.fill = wall_fill;
    part.edge = wall_edge;
    add_region(part, scene, wall);
    parts.push_back(std::move(part));
  }
  for (std::size_t k = 0; k < scene.body.size(); ++k) {
    Part part;
    part.kind = Part::Kind::body;
    const Color c = body_color(scene, k);
    part.fill = {float(c.r) / 255, float(c.g) / 255, float(c.b) / 255, 1};
    part.edge = {0.4f * part.fill.r, 0.4f * part.fill.g, 0.4f * part.fill.b, 1};
    part.body = int(k);
    part.start = body_shape(scene.body[k]).center;
    add_region(part, scene, scene.body[k]);
    parts.push_back(std::move(part));
  }
  for (const Scene::Probe& probe : scene.probe) {
    Part part = probe_of(scene, probe);
    for (std::size_t k = 0; k < scene.body.size() && !probe.body.empty(); ++k)
      if (scene.body_name(k) == probe.body) {
        part.body = int(k);
        part.start = body_shape(scene.body[k]).center;
      }
    parts.push_back(std::move(part));
  }
  return parts;
}

Matrix placement_of(const Part& part, const Frame& frame) {
  Matrix m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (part.body < 0 || std::size_t(part.body) >= frame.bodies.size()) return m;
  const BodyState& s = frame.bodies[std::size_t(part.body)];
  const Rotation turn(s.orientation);
  for (int k = 0; k < 3; ++k) {
    Point axis{0, 0, 0};
    component(axis, k) = 1;
    const Point turned = turn(axis);
    m[std::size_t(4 * k)] = float(turned.x);
    m[std::size_t(4 * k + 1)] = float(turned.y);
    m[std::size_t(4 * k + 2)] = float(turned.z);
  }
  const Point moved = Point{s.position[0], s.position[1], s.position[2]} - turn(part.start);
  m[12] = float(moved.x);
  m[13] = float(moved.y);
  m[14] = float(moved.z);
  return m;
}

}  // namespace freshet::view

// SPDX-License-Identifier: MIT
#include "render/stage.h"

#include <numbers>

#include "render/bodies.h"
#include "render/box_span.h"
#include "render/color.h"
#include "render/triangle.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

constexpr Color wall_color{176, 172, 166};
constexpr float darkest_shadow = 0.62f;
constexpr double tiles_along = 12;  // the longer side of the floor
constexpr float tile_lightness = 0.55f, tile_contrast = 0.86f;
constexpr int circle_parts = 64;
constexpr int most_strides = 200;  // maximum number of steps of a ray towards a solid

Color mix(Color a, Color b, float f) {
  const auto part = [f](std::uint8_t u, std::uint8_t v) {
    return std::uint8_t(float(u) + f * (float(v) - float(u)));
  };
  return {part(a.r, b.r), part(a.g, b.g), part(a.b, b.b)};
}

/// Whether the domain has a floor: its bottom is neither open nor periodic.
bool has_bottom(const Scene& s) { return !s.periodic(1) && s.side_method(2) != WallMethod::open; }

}  // namespace

float brightness(Point n) { return brightness(float(dot(n, light_direction())), float(n.y)); }

Color lit(Color c, float light) {
  const auto part = [light](std::uint8_t v) {
    return std::uint8_t(std::clamp(float(v) * light, 0.0f, 255.0f));
  };
  return {part(c.r), part(c.g), part(c.b)};
}

Stage::Stage(const Scene& scene, const Frame& fluid, const View& view, Color ground,
             const StageStyle& style)
    : view_(view),
      low_(point_of(scene.domain.min)),
      high_(point_of(scene.domain.max)),
      has_floor_(has_bottom(scene) && view.eye.y > low_.y) {
  const bool light = is_light(ground);
  floor_ = mix(ground, light ? Color{120, 130, 145} : Color{150, 165, 190}, light ? 0.3f : 0.5f);
  if (style.tiles) {
    floor_ = mix(floor_, Color{225, 228, 230}, tile_lightness);
    tile_ = std::max(high_.x - low_.x, high_.z - low_.z) / tiles_along;
  }
  edge_ = mix(ground, light ? Color{0, 0, 0} : Color{255, 255, 255}, 0.45f);
  add_box_lines(low_, high_);
  for (const Scene::Wall& w : scene.wall) {
    if (is_mesh(w) && w.loaded) meshes_.push_back({w.loaded, w.side == Side::inside});
    if (!is_solid(w)) continue;
    const auto solid = solid_of<3>(w);
    if (solid.kind != SolidKind::plane && solid.fluid_inside) add_tank_lines(solid);
    else if (solid.kind != SolidKind::plane || solid.distance(view.eye) > 0)
      solids_.push_back(solid);
  }
  bodies_ = posed_bodies(scene, fluid);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    body_colors_.push_back(body_color(scene, k));
    body_tanks_.push_back(scene.body[k].side == Side::inside);
  }
  if (has_floor_) shadow_.emplace(scene, fluid, solids_, bodies_, style.fluid_opacity);
}

void Stage::add_box_lines(Point low, Point high) {
  for (int k = 0; k < 8; ++k)
    for (int d = 0; d < 3; ++d) {
      if (k >> d & 1) continue;
      const auto corner = [&](int c) {
        return Point{c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z};
      };
      lines_.push_back({corner(k), corner(k | 1 << d)});
    }
}

void Stage::add_circle(Point center, Point u, Point v) {
  const auto at = [&](int k) {
    const double angle = 2 * std::numbers::pi * k / circle_parts;
    return center + std::cos(angle) * u + std::sin(angle) * v;
  };
  for (int k = 0; k < circle_parts; ++k) lines_.push_back({at(k), at(k + 1)});
}

/// Adds the edges of a tank. Its faces are not drawn, so that the inside is visible.
void Stage::add_tank_lines(const Solid<3, double>& t) {
  if (t.kind == SolidKind::box) return add_box_lines(t.center - t.half, t.center + t.half);
  const double r = t.radius;
  if (t.kind == SolidKind::ball) {
    add_circle(t.center, {r, 0, 0}, {0, r, 0});
    add_circle(t.center, {0, r, 0}, {0, 0, r});
    add_circle(t.center, {0, 0, r}, {r, 0, 0});
    return;
  }
  const Point side = std::abs(t.axis.x) < 0.9 ? Point{1, 0, 0} : Point{0, 1, 0};
  Point u = cross(t.axis, side);
  u = r / norm(u) * u;
  const Point v = cross(t.axis, u), end = t.half_length * t.axis;
  add_circle(t.center - end, u, v);
  add_circle(t.center + end, u, v);
  for (const Point& w : {u, v, -1.0 * u, -1.0 * v})
    lines_.push_back({t.center - end + w, t.center + end + w});
}

Stage::Extent Stage::extent_of(const Solid<3, double>& solid) const {
  constexpr Extent all{0, 0, 1 << 30, 1 << 30};
  if (solid.kind == SolidKind::plane) return all;
  const Bounds b = bounds_of(solid);
  double left = 1e9, top = 1e9, right = -1, bottom = -1;
  for (int k = 0; k < 8; ++k) {
    const auto s =
        view_({k & 1 ? b.high.x : b.low.x, k & 2 ? b.high.y : b.low.y, k & 4 ? b.high.z : b.low.z});
    if (s.z < view_.nearest) return all;
    left = std::min(left, s.x);
    right = std::max(right, s.x);
    top = std::min(top, s.y);
    bottom = std::max(bottom, s.y);
  }
  const auto pixel = [](double x) { return int(std::clamp(x, -1.0, 1e9)); };
  return {pixel(left), pixel(top), pixel(right) + 1, pixel(bottom) + 1};
}

void Stage::draw(Band& band) const {
  if (has_floor_) draw_floor(band);
  for (const auto& solid : solids_) draw_solid(band, solid);
  for (const auto& mesh : meshes_)
    for (std::size_t k = 0; k < mesh.loaded->distance.mesh().triangles.size(); ++k)
      draw_triangle(band, mesh.loaded->distance.mesh(), int(k), mesh.tank, wall_color);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t k = 0; k < bodies_[b].triangles.size(); ++k)
      draw_triangle(band, bodies_[b], int(k), body_tanks_[b], body_colors_[b]);
  for (const Line& line : lines_) draw_line(band, line);
}

void Stage::draw_floor(Band& band) const {
  const float full = brightness({0, 1, 0});
  for (int y = band.top; y < band.top + band.rows; ++y) {
    // the camera does not roll, so the floor has one depth along a row
    const Point first = view_.ray(0.5, y + 0.5), step = view_.ray(1.5, y + 0.5) - first;
    const double z = (low_.y - view_.eye.y) / first.y;
    if (!(z > view_.nearest)) continue;
    for (int x = 0; x < band.width; ++x) {
      const double px = view_.eye.x + z * (first.x + x * step.x);
      const double pz = view_.eye.z + z * (first.z + x * step.z);
      if (px < low_.x || px > high_.x || pz < low_.z || pz > high_.z) continue;
      const float shadow = darkest_shadow * (*shadow_)(px, pz);
      band.paint(x, y, float(z), lit(floor_, full * (1 - shadow) * tile(px, pz)));
    }
  }
}

/// The brightness of the floor's tile at (x, z) [m].
float Stage::tile(double x, double z) const {
  if (tile_ == 0) return 1;
  const double i = std::floor((x - low_.x) / tile_), j = std::floor((z - low_.z) / tile_);
  return std::fmod(i + j, 2) == 0 ? 1 : tile_contrast;
}

/// Sphere tracing: it advances by the distance from the solid, from the entry of the ray into the
/// domain on. Where the domain cuts the solid, the hit has the normal of the domain's face.
std::optional<Stage::Hit> Stage::meet(const Solid<3, double>& solid, Point ray) const {
  const auto span = box_span(low_, high_, view_.eye, ray, view_.nearest);
  if (!span) return {};
  const double stride = 1 / norm(ray), close = 1e-4 * norm(high_ - low_);
  double z = span->enter;
  for (int k = 0; k < most_strides && z <= span->leave; ++k) {
    const Point p = view_.eye + z * ray;
    const double distance = solid.distance(p);
    if (distance < close) return Hit{z, k == 0 ? span->face : solid.normal(p)};
    z += distance * stride;
  }
  return {};
}

void Stage::draw_solid(Band& band, const Solid<3, double>& solid) const {
  const Extent e = extent_of(solid);
  for (int y = std::max(band.top, e.top); y < std::min(band.top + band.rows, e.bottom); ++y)
    for (int x = std::max(0, e.left); x < std::min(band.width, e.right); ++x)
      if (const auto hit = meet(solid, view_.ray(x + 0.5, y + 0.5)))
        band.paint(x, y, float(hit->z), lit(wall_color, brightness(hit->normal)));
}

/// Draws a triangle. Those of a tank are drawn only if the eye is on their inner side.
void Stage::draw_triangle(Band& band, const TriangleMesh& mesh, int triangle, bool tank,
                          Color surface) const {
  const auto corners = mesh.corners(triangle);
  Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double facing = dot(view_.eye - corners[0], normal);
  if (tank && facing >= 0) return;
  normal = (facing < 0 ? -1 : 1) / norm(normal) * normal;
  std::vector<Point> seen;  // x, y and 1/z of the corners after clipping at the nearest distance
  for (std::size_t k = 0; k < 3; ++k) {
    const Point a = corners[k], b = corners[(k + 1) % 3];
    const double za = dot(a - view_.eye, view_.forward) - view_.nearest,
                 zb = dot(b - view_.eye, view_.forward) - view_.nearest;
    const auto add = [&](Point p) {
      const auto s = view_(p);
      seen.push_back({s.x, s.y, 1 / s.z});
    };
    if (za >= 0) add(a);
    if ((za < 0) != (zb < 0)) add(a + za / (za - zb) * (b - a));
  }
  const Color color = lit(surface, brightness(normal));
  for (std::size_t k = 2; k < seen.size(); ++k) {
    const Point z{seen[0].z, seen[k - 1].z, seen[k].z};
    for_each_cell({{seen[0].x, seen[0].y}, {seen[k - 1].x, seen[k - 1].y}, {seen[k].x, seen[k].y}},
                  band.width, band.top, band.top + band.rows, [&](int x, int y, Point shares) {
                    band.paint(x, y, float(1 / dot(shares, z)), color);
                  });
  }
}

void Stage::draw_line(Band& band, const Line& line) const {
  Point a = line.a, b = line.b;
  const auto depth = [&](Point p) { return dot(p - view_.eye, view_.forward); };
  double za = depth(a), zb = depth(b);
  if (za > zb) {
    std::swap(a, b);
    std::swap(za, zb);
  }
  if (zb <= view_.nearest) return;
  if (za < view_.nearest) a = a + (view_.nearest - za) / (zb - za) * (b - a);
  const auto p = view_(a), q = view_(b);
  const double dx = q.x - p.x, dy = q.y - p.y,
               steps = std::ceil(std::max({std::abs(dx), std::abs(dy), 1.0}));
  // the part of the line in the band
  double first = 0, last = 1;
  const auto cut = [&](double from, double by, double low, double high) {
    if (by == 0) {
      if (from < low || from > high) last = -1;
      return;
    }
    const double u = (low - from) / by, v = (high - from) / by;
    first = std::max(first, std::min(u, v));
    last = std::min(last, std::max(u, v));
  };
  cut(p.x, dx, -2, band.width + 2);
  cut(p.y, dy, band.top - 2, band.top + band.rows + 2);
  for (double k = std::floor(first * steps); k <= last * steps; ++k) {
    const double t = std::min(k / steps, 1.0);
    const float z = float(0.998 / ((1 - t) / p.z + t / q.z));
    const int x = int(std::floor(p.x + t * dx)), y = int(std::floor(p.y + t * dy));
    for (int j = 0; j < oversampling; ++j)
      for (int i = 0; i < oversampling; ++i)
        if (band.holds(x + i, y + j)) band.paint(x + i, y + j, z, edge_);
  }
}

}  // namespace freshet

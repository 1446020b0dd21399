// SPDX-License-Identifier: MIT
#include "scene/model/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/model/region_rotation.h"
#include "scene/model/solid_of.h"
#include "scene/sample/point_cloud.h"

namespace freshet {
namespace {

using Corner = Vec<2, double>;

constexpr std::size_t most_corners = 5000;  // the check for crossings compares all pairs of sides

double cross_of(Corner a, Corner b) { return a.x * b.y - a.y * b.x; }

double signed_area(const Outline& x) {
  double twice = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    twice += cross_of(x[k] - x[0], x[(k + 1) % x.size()] - x[0]);
  return twice / 2;
}

Outline corners_of_box(const Scene::Region& r) {
  const auto box = solid_of<2>(r);
  const RegionRotation turn(r.rotation);
  Outline x;
  for (const Corner& corner : {Corner{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    x.push_back(box.center + turn(Corner{corner.x * box.half.x, corner.y * box.half.y}));
  return x;
}

Outline corners_of_disc(const Scene::Region& r) {
  constexpr int corners = 64;
  Outline x;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    x.push_back(
        {r.center[0] + r.radius * std::cos(angle), r.center[1] + r.radius * std::sin(angle)});
  }
  return x;
}

Outline corners_of_file(const PointCloud& cloud) {
  Outline x;
  for (std::size_t k = 0; k + 1 < cloud.x.size(); k += 2) x.push_back({cloud.x[k], cloud.x[k + 1]});
  return x;
}

/// Scaled, rotated and translated.
Outline placed(Outline x, const Scene::Region& r) {
  const RegionRotation turn(r.rotation);
  const Corner translation = r.translation.empty() ? Corner{} : vec_of<2>(r.translation);
  for (Corner& p : x) p = turn(r.scale * p) + translation;
  return x;
}

/// Closes a line by a horizontal base.
void add_base(Outline& x, double base) {
  if (x.empty()) return;
  const Corner first = x.front(), last = x.back();
  if (last.y != base) x.push_back({last.x, base});
  if (first.y != base) x.push_back({first.x, base});
}

Outline corners_of_polygon(const Scene::Region& r) {
  Outline x;
  for (const Vector& p : r.points) x.push_back({p[0], p[1]});
  if (!r.file.empty()) x = corners_of_file(read_points(r.file, 2));
  if (!r.base && x.size() > 1 && norm2(x.front() - x.back()) == 0)
    x.pop_back();  // written as a closed line
  x = placed(std::move(x), r);
  if (r.base) add_base(x, *r.base);
  return x;
}

/// Whether the segments from a to b and from c to d have a common point.
bool meet(Corner a, Corner b, Corner c, Corner d) {
  const double of_a = cross_of(d - c, a - c), of_b = cross_of(d - c, b - c),
               of_c = cross_of(b - a, c - a), of_d = cross_of(b - a, d - a);
  const auto between = [](Corner p, Corner q, Corner x) {
    return std::min(p.x, q.x) <= x.x && x.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= x.y &&
           x.y <= std::max(p.y, q.y);
  };
  return (of_a * of_b < 0 && of_c * of_d < 0) || (of_a == 0 && between(c, d, a)) ||
         (of_b == 0 && between(c, d, b)) || (of_c == 0 && between(a, b, c)) ||
         (of_d == 0 && between(a, b, d));
}

}  // namespace

Outline outline_of(const Scene::Region& r) {
  Outline x = r.shape == Shape::box      ? corners_of_box(r)
              : r.shape == Shape::sphere ? corners_of_disc(r)
                                         : corners_of_polygon(r);
  if (signed_area(x) < 0) std::reverse(x.begin(), x.end());
  return x;
}

std::optional<OutlineFault> fault_in(const Outline& x) {
  const std::size_t n = x.size();
  if (n < 3)
    return OutlineFault{fmt::format("has {} corner{}; write at least three", n, n == 1 ? "" : "s")};
  if (n > most_corners)
    return OutlineFault{
        fmt::format("has {} corners; at most {} are allowed; remove some", n, most_corners)};
  for (std::size_t k = 0; k < n; ++k)
    if (norm2(x[k] - x[(k + 1) % n]) == 0)
      return OutlineFault{fmt::format("has the corner [{:g}, {:g}] twice in succession; remove one",
                                      x[k].x, x[k].y),
                          int((k + 1) % n)};
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = k + 2; j < n; ++j)
      if ((k > 0 || j + 1 < n) && meet(x[k], x[k + 1], x[j], x[(j + 1) % n]))
        return OutlineFault{
            fmt::format(
                "crosses or touches itself: its sides from [{:g}, {:g}] to [{:g}, {:g}] and from "
                "[{:g}, {:g}] to [{:g}, {:g}] meet; sort the corners along the outline",
                x[k].x, x[k].y, x[k + 1].x, x[k + 1].y, x[j].x, x[j].y, x[(j + 1) % n].x,
                x[(j + 1) % n].y),
            int(j)};
  if (!(signed_area(x) > 0))
    return OutlineFault{"encloses no area; write corners that are not on one line"};
  return {};
}

void require_valid(const Outline& x, const Scene::Region& r) {
  const auto fault = fault_in(x);
  if (!fault) return;
  std::string place = r.file, words = fault->words;
  if (fault->corner >= 0 && !r.file.empty() && r.shape == Shape::polygon) {
    const PointCloud cloud = read_points(r.file, 2);
    const Outline corners = placed(corners_of_file(cloud), r);
    const Corner at = x[std::size_t(fault->corner)];
    for (std::size_t k = corners.size(); k-- > 0;)  // the last: a corner may be there twice
      if (k < cloud.lines.size() && norm2(corners[k] - at) == 0) {
        place += fmt::format(":{}", cloud.lines[k]);
        words = "the polygon " + words;
        break;
      }
  }
  throw Error(Error::Kind::scene, place, words);
}

/// Counts the sides that a ray along x crosses.
bool encloses(const Outline& outline, Corner x) {
  bool inside = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Corner a = outline[k], b = outline[(k + 1) % outline.size()];
    const bool left = cross_of(b - a, x - a) > 0;
    if ((a.y > x.y) != (b.y > x.y) && left == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

double perimeter_of(const Outline& x) {
  double length = 0;
  for (std::size_t k = 0; k < x.size(); ++k) length += norm(x[(k + 1) % x.size()] - x[k]);
  return length;
}

TriangleMesh prism_of(const Outline& x) {
  const double z = perimeter_of(x) / 2;  // the diameter at least
  TriangleMesh mesh;
  const int n = int(x.size());
  for (const Corner& p : x) mesh.points.push_back({p.x, p.y, -z});
  for (const Corner& p : x) mesh.points.push_back({p.x, p.y, z});
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    mesh.triangles.push_back({k, next, n + next});
    mesh.triangles.push_back({k, n + next, n + k});
  }
  return mesh;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/sample/membranes.h"

#include <algorithm>
#include <cmath>

#include "scene/model/body_mesh.h"
#include "scene/model/loaded_mesh.h"
#include "scene/sample/join_points.h"
#include "scene/sample/places.h"
#include "scene/sample/point_cloud.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

using Point = TriangleMesh::Point;
using Corners = std::array<Point, 3>;

void append(TriangleMesh& to, const Corners& corners) {
  const int first = int(to.points.size());
  to.points.insert(to.points.end(), corners.begin(), corners.end());
  to.triangles.push_back({first, first + 1, first + 2});
}

/// The triangles of a closed surface where it is thin, in pieces of about the size of `thin`.
class ThinParts {
 public:
  ThinParts(const MeshDistance& surface, double thin) : surface_(surface), thin_(thin) {}

  void add(const Corners& t, TriangleMesh& to) const {
    int longest = 0;
    const auto side = [&](int k) { return norm(t[std::size_t((k + 1) % 3)] - t[std::size_t(k)]); };
    for (int k = 1; k < 3; ++k)
      if (side(k) > side(longest)) longest = k;
    if (side(longest) <= thin_) {
      if (is_thin(t)) append(to, t);
      return;
    }
    const Point a = t[std::size_t(longest)], b = t[std::size_t((longest + 1) % 3)],
                c = t[std::size_t((longest + 2) % 3)], middle = 0.5 * (a + b);
    add({a, middle, c}, to);
    add({middle, b, c}, to);
  }
  /// The strips, 2 `width` wide, of the sides of an outline.
  void add(const Outline& outline, double width, TriangleMesh& to) const {
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const auto from = outline[k], whole = outline[(k + 1) % outline.size()] - from;
      const auto parts = std::max<std::int64_t>(1, std::int64_t(std::ceil(norm(whole) / thin_)));
      for (std::int64_t j = 0; j < parts; ++j) {
        const auto a = from + double(j) / double(parts) * whole,
                   b = from + double(j + 1) / double(parts) * whole;
        const Point low{a.x, a.y, -width}, high{b.x, b.y, width};
        const Corners lower{low, Point{b.x, b.y, -width}, high},
            upper{low, high, Point{a.x, a.y, width}};
        if (!is_thin({lower[0], lower[1], 0.5 * (upper[2] + lower[1])})) continue;
        append(to, lower);
        append(to, upper);
      }
    }
  }

 private:
  bool is_thin(const Corners& t) const {
    const Point outwards = cross(t[1] - t[0], t[2] - t[0]);
    const double area = norm(outwards);
    if (!(area > 0)) return false;
    const auto thickness =
        surface_.first_hit((t[0] + t[1] + t[2]) / 3, (-1 / area) * outwards, 1e-6 * thin_);
    return thickness && *thickness < thin_;
  }

  const MeshDistance& surface_;
  double thin_;
};

/// The thin parts of a region that is not a plane, points or a sheet, with the fluid outside.
TriangleMesh thin_parts(const Scene::Region& r, int dimension, double thin) {
  TriangleMesh parts;
  if (dimension == 2) {
    const Outline outline = is_mesh(r) ? r.loaded->outline : outline_of(r);
    const MeshDistance prism(prism_of(outline));
    ThinParts(prism, thin).add(outline, thin, parts);
    return parts;
  }
  Scene::Body body;
  static_cast<Scene::Region&>(body) = r;
  const MeshDistance surface(body_mesh(body));
  for (int t = 0; t < int(surface.mesh().triangles.size()); ++t)
    ThinParts(surface, thin).add(surface.mesh().corners(t), parts);
  return parts;
}

/// Appends a mesh, and its images beyond periodic ends.
template <int D> void append_all(TriangleMesh& to, const TriangleMesh& mesh, const Scene& s) {
  for (auto shift : periodic_shifts<D>(s)) {
    Point move{};
    for (int k = 0; k < D; ++k) component(move, k) = component(shift, k);
    for (int t = 0; t < int(mesh.triangles.size()); ++t) {
      auto corners = mesh.corners(t);
      for (Point& p : corners) p += move;
      append(to, corners);
    }
  }
}

template <int D> std::vector<Membrane> membranes(const Scene& s, double thin) {
  TriangleMesh sheets, solids;
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    const Scene::Wall& w = s.wall[k];
    if (wall_layers(s, s.wall_method(k)) == 0) continue;
    if (w.shape == Shape::points)
      append_all<D>(sheets, join_points(region_points(w, D).x, D, s.particles.spacing), s);
    else if (w.shape == Shape::mesh && !w.loaded->condition.closed())
      append_all<D>(sheets, w.loaded->distance.mesh(), s);
    else if (w.shape != Shape::plane && w.side == Side::outside)
      append_all<D>(solids, thin_parts(w, D, thin), s);
  }
  std::vector<Membrane> all;
  const auto add = [&](TriangleMesh mesh, bool two_sided, int body) {
    if (!mesh.triangles.empty()) all.push_back({MeshDistance(std::move(mesh)), two_sided, body});
  };
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& b = s.body[k];
    if (b.side == Side::inside) continue;
    if (b.motion == BodyMotion::fixed) append_all<D>(solids, thin_parts(b, D, thin), s);
    else add(thin_parts(b, D, std::min(thin, 2 * s.particles.spacing)), false, int(k));
  }
  add(std::move(sheets), true, -1);
  add(std::move(solids), false, -1);
  return all;
}

}  // namespace

std::vector<Membrane> membranes_of(const Scene& s, double thin) {
  return s.dimension() == 2 ? membranes<2>(s, thin) : membranes<3>(s, thin);
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/sample/mesh_surface.h"

#include <algorithm>
#include <cmath>

#include "scene/sample/point_grid.h"

namespace freshet {
namespace {

using Point = Vec<3, double>;

constexpr double apart = 0.7;  // spacings: sparser layers let impinging particles through
constexpr double apart_in_thin_walls = 0.5;  // these are closer to the water: see MeshWalls tests
constexpr double apart_in_layers = 0.8;      // spacings: as many points as a lattice has
constexpr int rounds = 40;                   // with about one throw per disc
constexpr double clear = 0.95;  // fraction of the depth: minimum distance to all of the surface

/// SplitMix64 [Steele, Lea and Flood 2014]: the same random numbers on every platform.
class Throws {
 public:
  /// In [0, 1).
  double operator()() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  Point on(const std::array<Point, 3>& t) {
    double u = (*this)(), v = (*this)();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
  }

 private:
  std::uint64_t state_ = 0;
};

enum class MeshPlaces { all, thick, thin };  // of a mesh

class Spreader {
 public:
  /// No two points are closer than `radius`, in one layer or in two.
  Spreader(const MeshDistance& mesh, double radius)
      : mesh_(mesh), radius_(radius), taken_(radius_) {}

  /// Points `depth` behind the surface. Where the mesh is too thin for this depth, or the depth is
  /// 0, they are in its middle. Only at these `places`.
  void spread(double depth, MeshPlaces places = MeshPlaces::all) {
    set_depth(depth);
    places_ = places;
    for (int round = 0; round < rounds; ++round)
      for (std::size_t k = 0; k < mesh_.mesh().triangles.size(); ++k) throw_on(int(k));
  }
  /// Walks along an outline, counterclockwise, whose prism is the mesh.
  void walk(const Outline& outline, double spacing, double depth) {
    set_depth(depth);
    const std::size_t n = outline.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Flat a = outline[k], b = outline[(k + 1) % n],
                 before = normal_of(outline[(k + n - 1) % n], a), normal = normal_of(a, b),
                 after = normal_of(b, outline[(k + 2) % n]);
      if (!has_miter(before, normal)) turn_corner(a, before, normal, spacing);
      const Flat from = corner_of(a, before, normal, normal),
                 to = corner_of(b, normal, after, normal);
      const double length = norm(to - from);
      const auto parts = std::max<std::int64_t>(1, std::llround(length / spacing));
      for (std::int64_t j = 0; j < parts; ++j) {
        const Flat x = from + double(j) / double(parts) * (to - from),
                   on = x + -side_ * depth_ * normal;
        const double along = dot(on - a, b - a) / norm2(b - a);
        const bool beside = along < -1e-9 || along > 1 + 1e-9;  // beyond a mitred corner
        if (!beside || mesh_.nearest(lift(x)).distance >= clear * depth_)
          add(lift(on), lift(side_ * normal));
      }
    }
  }
  bool has_thin_places() const { return has_thin_; }
  std::vector<Point> points() { return std::move(all_); }

 private:
  using Flat = Vec<2, double>;

  static Point lift(Flat x) { return {x.x, x.y, 0}; }
  /// The unit normal of a side, outwards.
  static Flat normal_of(Flat a, Flat b) {
    const Flat along = b - a;
    return Flat{along.y, -along.x} / norm(along);
  }
  /// Whether the corner of a layer lies on the sides' bisector: a sharp one would lie far away.
  static bool has_miter(Flat m, Flat n) { return dot(m, n) > -0.5; }
  /// The corner of a layer at a corner of the outline between sides of the normals m and n; without
  /// a mitre, the end of the side of normal `own`.
  Flat corner_of(Flat x, Flat m, Flat n, Flat own) const {
    if (!has_miter(m, n)) return x + side_ * depth_ * own;
    return x + side_ * depth_ / (1 + dot(m, n)) * (m + n);
  }
  /// Points on the arc around a sharp corner.
  void turn_corner(Flat x, Flat m, Flat n, double spacing) {
    const double angle = std::atan2(m.x * n.y - m.y * n.x, dot(m, n));
    const auto parts = std::max<std::int64_t>(1, std::llround(std::abs(angle) * depth_ / spacing));
    for (std::int64_t j = 0; j < parts; ++j) {
      const double turned = angle * double(j) / double(parts), c = std::cos(turned),
                   s = std::sin(turned);
      const Flat to{c * m.x - s * m.y, s * m.x + c * m.y};
      if (mesh_.nearest(lift(x + side_ * depth_ * to)).distance >= clear * depth_)
        add(lift(x), lift(side_ * to));
    }
  }
  void set_depth(double depth) {
    depth_ = std::abs(depth);
    side_ = depth > 0 ? -1 : 1;
  }
  void throw_on(int triangle) {
    const auto t = mesh_.mesh().corners(triangle);
    const Point area_normal = 0.5 * cross(t[1] - t[0], t[2] - t[0]);
    const double area = norm(area_normal);
    if (!(area > 0)) return;
    const double wanted = area / (radius_ * radius_) + throws_();
    for (double k = 1; k <= wanted; ++k) add(throws_.on(t), side_ / area * area_normal);
  }
  void add(Point on, Point inwards) {
    Point x = on + depth_ * inwards;
    bool thin = depth_ == 0;
    if (depth_ > 0 && mesh_.nearest(x).distance < clear * depth_) {
      const auto room = mesh_.first_hit(on, inwards, 1e-9 * depth_);
      if (!room || *room >= 2 * depth_) return;  // in front of a corner
      x = on + *room / 2 * inwards;
      if (mesh_.nearest(x).distance < clear * *room / 2) return;
      thin = true;
    }
    has_thin_ |= thin;
    if (places_ == (thin ? MeshPlaces::thick : MeshPlaces::thin)) return;
    if (taken_.comes_near(x)) return;
    taken_.add(x);
    all_.push_back(x);
  }

  const MeshDistance& mesh_;
  double radius_, depth_ = 0, side_ = 1;
  MeshPlaces places_ = MeshPlaces::all;
  bool has_thin_ = false;
  Throws throws_;
  PointGrid<3> taken_;
  std::vector<Point> all_;
};

}  // namespace

std::vector<Point> points_behind(const MeshDistance& mesh, double spacing, double depth) {
  std::vector<Point> points;
  bool thin = depth == 0;
  if (!thin) {
    Spreader spreader(mesh, apart * spacing);
    spreader.spread(depth, MeshPlaces::thick);
    thin = spreader.has_thin_places();
    points = spreader.points();
  }
  if (thin) {
    Spreader spreader(mesh, apart_in_thin_walls * spacing);
    spreader.spread(depth, MeshPlaces::thin);
    const auto more = spreader.points();
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

std::vector<Vec<2, double>> points_behind(const Outline& outline, const MeshDistance& prism,
                                          double spacing, std::span<const double> depths) {
  Spreader spreader(prism, apart * spacing);
  for (const double depth : depths) spreader.walk(outline, spacing, depth);
  std::vector<Vec<2, double>> flat;
  for (const Point& x : spreader.points()) flat.push_back({x.x, x.y});
  return flat;
}

std::vector<Point> layers_behind(const MeshDistance& mesh, double spacing, int layers,
                                 bool fluid_inside) {
  Spreader spreader(mesh, apart_in_layers * spacing);
  for (int k = 0; k < layers; ++k) spreader.spread((fluid_inside ? -1 : 1) * (k + 0.5) * spacing);
  return spreader.points();
}

}  // namespace freshet

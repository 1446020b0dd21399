// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "bodies/bodies.h"
#include "core/rotation.h"
#include "scene/sample/region_surface.h"

namespace freshet {

/// The solids of a scene at one time: the sides of the domain, the walls and the bodies. Walls of
/// points are missing, as they have no surface.
template <int D> class Solids {
 public:
  using Point = Vec<D, double>;

  /// `scene` has its defaults filled in. It and `bodies`, which may be null, must outlive this.
  Solids(const Scene& scene, const Bodies* bodies) {
    const std::vector<std::string> names = scene.wall_names();
    for (int side = 0; side < 2 * D; ++side)
      if (!scene.periodic(side / 2) && !scene.is_open(side)) {
        const auto axis = std::size_t(side / 2);
        sides_.push_back({side, (side % 2 ? scene.domain.max : scene.domain.min)[axis],
                          names[std::size_t(side)]});
      }
    for (std::size_t k = 0; k < scene.wall.size(); ++k)
      if (scene.wall[k].shape != Shape::points)
        walls_.push_back(
            {RegionSurface<D>(scene.wall[k], scene.particles.spacing), names[2 * D + k]});
    for (std::size_t k = 0; bodies && k < bodies->size(); ++k)
      bodies_.push_back({RegionSurface<D>(scene.body[k], scene.particles.spacing),
                         scene.body_name(k), flat(bodies->center(k)), bodies->states()[k],
                         scene.body[k].motion == BodyMotion::moved});
  }

  std::size_t size() const { return sides_.size() + walls_.size() + bodies_.size(); }
  /// The index of the first wall, after the sides, and of the first body, after the walls.
  std::size_t first_wall() const { return sides_.size(); }
  std::size_t first_body() const { return sides_.size() + walls_.size(); }
  bool is_moved(std::size_t k) const { return k >= first_body() && body(k).moved; }
  const std::string& name(std::size_t k) const {
    return k < first_wall() ? sides_[k].name : k < first_body() ? wall(k).name : body(k).name;
  }

  /// The distance of x from the surface [m]: negative inside the solid.
  double distance(std::size_t k, Point x) const {
    if (k >= first_body()) return body(k).surface.distance(in_start_frame(body(k), x));
    if (k >= first_wall()) return wall(k).surface.distance(x);
    const double beyond = component(x, sides_[k].number / 2) - sides_[k].at;
    return sides_[k].number % 2 ? -beyond : beyond;
  }
  /// The direction in which the distance grows, by differences over `length` [m].
  Point normal(std::size_t k, Point x, double length) const {
    Point slope{};
    for (int d = 0; d < D; ++d) {
      Point ahead = x, behind = x;
      component(ahead, d) += length / 2;
      component(behind, d) -= length / 2;
      component(slope, d) = distance(k, ahead) - distance(k, behind);
    }
    const double steep = norm(slope);
    return steep > 0 ? slope / steep : slope;
  }
  /// The speed at which the surface moves towards x, along `normal` [m/s].
  double approach(std::size_t k, Point x, Point normal) const {
    if (k < first_body()) return 0;
    const BodyState& s = body(k).state;
    return dot(deep(normal),
               point(s.velocity) + cross(point(s.angular_velocity), deep(x) - point(s.position)));
  }

 private:
  struct SideOfDomain {
    int number;
    double at;
    std::string name;
  };
  struct Wall {
    RegionSurface<D> surface;
    std::string name;
  };
  struct Body {
    RegionSurface<D> surface;
    std::string name;
    Point start;
    BodyState state;
    bool moved;
  };

  static Vec<3, double> point(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
  static Point flat(const std::array<double, 3>& a) {
    if constexpr (D == 3) return {a[0], a[1], a[2]};
    else return {a[0], a[1]};
  }
  static Vec<3, double> deep(Point x) {
    if constexpr (D == 3) return x;
    else return {x.x, x.y, 0};
  }
  static Point in_start_frame(const Body& b, Point x) {
    const auto back =
        Rotation(b.state.orientation).inverse(deep(x) - point(b.state.position)) + deep(b.start);
    if constexpr (D == 3) return back;
    else return {back.x, back.y};
  }
  const Wall& wall(std::size_t k) const { return walls_[k - first_wall()]; }
  const Body& body(std::size_t k) const { return bodies_[k - first_body()]; }

  std::vector<SideOfDomain> sides_;
  std::vector<Wall> walls_;
  std::vector<Body> bodies_;
};

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "sim/surfaces.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/rotation.h"
#include "scene/model/body_shape.h"
#include "scene/model/setup.h"
#include "scene/sample/places.h"
#include "scene/sample/region_surface.h"

namespace freshet {

struct Surfaces::Geometry {
  virtual ~Geometry() = default;
  virtual SurfacePoints load(const BoundaryForces& boundary,
                             const std::vector<BodyState>& bodies) const = 0;
};

namespace {

/// The point of a surface that a boundary particle belongs to.
template <int D> struct OnSurface {
  Vec<D, double> x, normal;
  double depth;  ///< of the boundary particle behind the surface [m]
};

/// The surfaces of the parts of a scene.
template <int D> class Parts {
 public:
  explicit Parts(const Scene& s) : scene_(s), shifts_(periodic_shifts<D>(s)) {
    const double spacing = s.particles.spacing;
    for (const Scene::Wall& w : s.wall) add(w, spacing);
    for (const Scene::Body& b : s.body) {
      add(b, spacing);
      centers_.push_back(body_shape(b).center);
    }
  }

  OnSurface<D> at(std::size_t part, Vec<D, double> x, const std::vector<BodyState>& bodies) const {
    if (part < sides) return on_side(int(part), x);
    const auto& surface = surfaces_[part - sides];
    const std::size_t walls = sides + scene_.wall.size();
    if (part < walls) return on(surface, x);
    std::optional<OnSurface<D>> nearest;
    for (const auto& shift : shifts_) {  // body particles are within periodic ends
      auto point = on_body(surface, centers_[part - walls], bodies[part - walls], x + shift);
      point.x = point.x - shift;
      if (!nearest || std::abs(point.depth) < std::abs(nearest->depth)) nearest = point;
    }
    return *nearest;
  }
  WallMethod method(std::size_t part) const {
    if (part < sides) return scene_.side_method(int(part));
    const std::size_t wall = part - sides;
    return wall < scene_.wall.size() ? scene_.wall_method(wall) : body_method(scene_);
  }

 private:
  static constexpr std::size_t sides = 2 * D;
  void add(const Scene::Region& region, double spacing) {
    surfaces_.emplace_back();
    if (region.shape != Shape::points) surfaces_.back().emplace(region, spacing);
  }
  OnSurface<D> on_side(int side, Vec<D, double> x) const {
    const int k = side / 2;
    const bool low = side % 2 == 0;
    const double end = (low ? scene_.domain.min : scene_.domain.max)[std::size_t(k)];
    OnSurface<D> point{x, {}, (low ? 1 : -1) * (end - component(x, k))};
    component(point.x, k) = end;
    component(point.normal, k) = low ? 1 : -1;
    return point;
  }
  /// `center`: of mass at the start.
  static OnSurface<D> on_body(const std::optional<RegionSurface<D>>& surface, Vec<3, double> center,
                              const BodyState& body, Vec<D, double> x) {
    const Rotation turn(body.orientation);
    const Vec<3, double> at{body.position[0], body.position[1], body.position[2]};
    OnSurface<D> point = on(surface, flat(center + turn.inverse(in_space(x) - at)));
    point.x = flat(at + turn(in_space(point.x) - center));
    point.normal = flat(turn(in_space(point.normal)));
    return point;
  }
  /// Points of a file have no surface.
  static OnSurface<D> on(const std::optional<RegionSurface<D>>& surface, Vec<D, double> x) {
    if (!surface) return {x, {}, 0};
    const double depth = -surface->distance(x);
    const auto normal = surface->normal(x);
    return {x + depth * normal, normal, depth};
  }
  static Vec<3, double> in_space(Vec<D, double> x) {
    if constexpr (D == 3) return x;
    else return {x.x, x.y, 0};
  }
  static Vec<D, double> flat(Vec<3, double> x) {
    if constexpr (D == 3) return x;
    else return {x.x, x.y};
  }

  const Scene& scene_;
  std::vector<Vec<D, double>> shifts_;
  std::vector<std::optional<RegionSurface<D>>> surfaces_;  // of the walls, then of the bodies
  std::vector<Vec<3, double>> centers_;                    // of the bodies at the start
};

template <int D> class GeometryIn final : public Surfaces::Geometry {
 public:
  explicit GeometryIn(const Scene& s) : parts_(s), spacing_(s.particles.spacing) {}

  SurfacePoints load(const BoundaryForces& boundary,
                     const std::vector<BodyState>& bodies) const override {
    std::map<int, Skin> skins;  // by part
    std::vector<std::pair<int, Loaded>> behind;
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      const int part = boundary.part[k];
      const auto point = parts_.at(std::size_t(part), vector(boundary.x, k), bodies);
      const Loaded loaded{point.x, point.normal, vector(boundary.force, k)};
      const bool layered = parts_.method(std::size_t(part)) == WallMethod::adami2012;
      if (layered && point.depth > spacing_) behind.emplace_back(part, loaded);
      else skins.try_emplace(part, spacing_).first->second.add(loaded);
    }
    for (const auto& [part, loaded] : behind)
      skins.try_emplace(part, spacing_).first->second.add_behind(loaded);
    return points_of(skins);
  }

 private:
  struct Loaded {
    Vec<D, double> x, normal, force;
  };
  /// The points of one part.
  struct Skin {
    explicit Skin(double spacing) : grid(1.5 * spacing) {}
    void add(const Loaded& point) {
      grid.add(point.x);
      points.push_back(point);
    }
    /// Adds the load of a boundary particle of a deeper layer to the nearest point.
    void add_behind(const Loaded& deep) {
      if (points.empty()) return add(deep);
      std::size_t nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      const auto compare = [&](std::size_t k) {
        const double away = norm2(points[k].x - deep.x);
        if (away < least) least = away, nearest = k;
      };
      for (const int k : grid.near(deep.x)) compare(std::size_t(k));
      if (std::isinf(least))
        for (std::size_t k = 0; k < points.size(); ++k) compare(k);
      points[nearest].force += deep.force;
    }
    PointGrid<D> grid;
    std::vector<Loaded> points;
  };

  static Vec<D, double> vector(const std::vector<double>& all, std::size_t k) {
    Vec<D, double> v{};
    for (std::size_t d = 0; d < D; ++d) component(v, int(d)) = all[D * k + d];
    return v;
  }
  static void append(std::vector<float>& to, Vec<D, double> v) {
    for (int d = 0; d < D; ++d) to.push_back(float(component(v, d)));
  }
  SurfacePoints points_of(const std::map<int, Skin>& skins) const {
    SurfacePoints all;
    all.dimension = D;
    all.area = std::pow(spacing_, D - 1);
    for (const auto& [part, skin] : skins)
      for (const Loaded& point : skin.points) {
        const auto traction = point.force / all.area;
        append(all.x, point.x);
        append(all.normal, point.normal);
        append(all.traction, traction);
        all.pressure.push_back(norm2(point.normal) > 0 ? float(0 - dot(traction, point.normal))
                                                       : std::numeric_limits<float>::quiet_NaN());
        all.part.push_back(part);
      }
    return all;
  }

  Parts<D> parts_;
  double spacing_;
};

}  // namespace

Surfaces::Surfaces(const Scene& scene) {
  if (scene.dimension() == 2) geometry_ = std::make_unique<GeometryIn<2>>(scene);
  else geometry_ = std::make_unique<GeometryIn<3>>(scene);
}
Surfaces::~Surfaces() = default;

SurfacePoints Surfaces::load(const BoundaryForces& boundary,
                             const std::vector<BodyState>& bodies) const {
  return geometry_->load(boundary, bodies);
}

std::vector<Vector> forces_on_parts(const Scene& scene, const BoundaryForces& boundary) {
  const auto D = std::size_t(scene.dimension());
  std::vector<Vector> all(scene.wall_names().size() + scene.body.size(), Vector(D, 0.0));
  for (std::size_t k = 0; k < boundary.size(); ++k)
    for (std::size_t d = 0; d < D; ++d)
      all[std::size_t(boundary.part[k])][d] += boundary.force[D * k + d];
  return all;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "scene/sample/sample_bodies.h"

#include "scene/model/loaded_mesh.h"
#include "scene/sample/akinci_layer.h"
#include "scene/sample/ball_layer.h"
#include "scene/sample/region_layers.h"
#include "scene/sample/region_surface.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

/// One layer, as in a wall of akinci2012.
template <int D> std::vector<Vec<D, double>> layer_of(const Scene& s, const Scene::Region& body) {
  const AkinciLayer layer(s);
  if constexpr (D == 3)
    if (body.shape == Shape::mesh)
      return points_behind(body.loaded->distance, s.particles.spacing,
                           body.side == Side::inside ? -layer.depth() : layer.depth());
  if constexpr (D == 2)
    if (body.shape == Shape::polygon)
      return layers_of_polygon(body, s.particles.spacing, 1, layer.setback());
  const auto solid = solid_of<D>(body);
  if constexpr (D == 3)
    if (has_ball_layer(s, body)) return ball_layer(s, solid);
  auto points = Surface<D>(solid, s.particles.spacing, 1).points({}, {}, {});
  for (auto& x : points) layer.settle(solid, x);
  turn_with<D>(body, points);
  return points;
}

/// Several layers, as in a wall of adami2012.
template <int D> std::vector<Vec<D, double>> layers_of(const Scene& s, const Scene::Region& body) {
  const double spacing = s.particles.spacing;
  const int layers = wall_layers(s, WallMethod::adami2012);
  if constexpr (D == 3)
    if (body.shape == Shape::mesh)
      return layers_behind(body.loaded->distance, spacing, layers, body.side == Side::inside);
  if constexpr (D == 2)
    if (body.shape == Shape::polygon) return layers_of_polygon(body, spacing, layers, 0);
  const auto solid = solid_of<D>(body);
  auto points = Surface<D>(solid, spacing, layers).points({}, {}, {});
  turn_with<D>(body, points);
  return points;
}

}  // namespace

template <int D> void sample_bodies(const Scene& s, Sample& all) {
  if (s.body.empty()) return;
  const bool layered = body_method(s) == WallMethod::adami2012;
  const AkinciLayer layer(s);
  for (std::size_t b = 0; b < s.body.size(); ++b) {
    const RegionSurface<D> surface(s.body[b], s.particles.spacing);
    const bool fitted = has_ball_layer(s, s.body[b]);  // by its depth
    for (Vec<D, double> x : layered ? layers_of<D>(s, s.body[b]) : layer_of<D>(s, s.body[b])) {
      for (int k = 0; k < D; ++k) all.bodies.x.push_back(component(x, k));
      all.bodies.body.push_back(std::int32_t(b));
      if (!layered)
        all.bodies.volume_factor.push_back(fitted ? 1 : layer.volume_factor(s.body[b], surface, x));
    }
  }
}

template void sample_bodies<2>(const Scene&, Sample&);
template void sample_bodies<3>(const Scene&, Sample&);

double most_body_samples(const Scene& s) {
  double all = 0, images = 1;
  const int layers = wall_layers(s, body_method(s));
  for (const Scene::Body& body : s.body)
    all += (has_ball_layer(s, body) ? 4 : 1) * most_samples(s, body, layers);
  for (int k = 0; k < s.dimension(); ++k) images *= s.periodic(k) ? 2 : 1;
  return all * (1 + images);
}

}  // namespace freshet

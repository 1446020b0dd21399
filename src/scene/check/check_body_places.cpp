// SPDX-License-Identifier: MIT
/// Where bodies start: inside the domain, apart from walls and from each other.
#include <algorithm>

#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/body_shape.h"
#include "scene/model/setup.h"
#include "scene/sample/region_surface.h"
#include "scene/sample/sample_bodies.h"

namespace freshet {
namespace {

/// The body particles, by body.
template <int D> std::vector<std::vector<Vec<D, double>>> samples_of(const Scene& s) {
  Sample all;
  sample_bodies<D>(s, all);
  std::vector<std::vector<Vec<D, double>>> samples(s.body.size());
  for (std::size_t k = 0; k < all.bodies.body.size(); ++k) {
    Vec<D, double> x{};
    for (int d = 0; d < D; ++d) component(x, d) = all.bodies.x[D * k + std::size_t(d)];
    samples[std::size_t(all.bodies.body[k])].push_back(x);
  }
  return samples;
}

/// The side that body particles lie farthest beyond, of those that are not open.
struct Beyond {
  int side = 0;
  double distance = 0;  ///< [m]
  void see(const Scene& s, int of, double far) {
    if (s.side_method(of) == WallMethod::open || !(far > distance)) return;
    side = of;
    distance = far;
  }
};

template <int D> bool check_places(const Scene& s, bool walls_are_good, Findings& out) {
  const auto samples = samples_of<D>(s);
  std::vector<RegionSurface<D>> bodies;
  for (const Scene::Body& b : s.body) bodies.emplace_back(b, s.particles.spacing);
  bool good = true;
  const auto complain = [&](std::size_t k, const std::string& what) {
    out.error(fmt::format("body[{}]", k), what);
    return good = false;
  };
  const auto meets = [](const auto& points, const RegionSurface<D>& surface) {
    return std::any_of(points.begin(), points.end(),
                       [&](const auto& x) { return surface.distance(x) < 0; });
  };
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const std::string name = s.body_name(k);
    if (samples[k].empty()) {
      complain(k,
               fmt::format("{} has no particles at spacing {}: it is too thin everywhere; make it "
                           "thicker or the spacing smaller",
                           name, s.particles.spacing));
      continue;
    }
    bool inside = false;
    Beyond beyond;
    for (Vec<D, double> x : samples[k]) {
      bool in = true;
      for (int d = 0; d < D; ++d) {
        const auto j = std::size_t(d);
        if (s.periodic(d)) continue;
        const bool low = component(x, d)<s.domain.min[j], high = component(x, d)> s.domain.max[j];
        in &= !low && !high;
        if (low) beyond.see(s, 2 * d, s.domain.min[j] - component(x, d));
        if (high) beyond.see(s, 2 * d + 1, component(x, d) - s.domain.max[j]);
      }
      inside |= in;
    }
    const bool free = s.body[k].motion == BodyMotion::free;
    if (!inside) complain(k, fmt::format("{} is outside the domain; move it inside", name));
    else if (free && beyond.distance > 0)
      complain(k, fmt::format("{} extends through the side \"{}\" of the domain: its body "
                              "particles lie up to {:.4g} m beyond "
                              "it, and a free body must start inside; move it or make it smaller",
                              name, s.wall_names()[std::size_t(beyond.side)], beyond.distance));
    for (std::size_t w = 0; free && walls_are_good && w < s.wall.size(); ++w)
      if (s.wall[w].shape != Shape::points &&
          meets(samples[k], RegionSurface<D>(s.wall[w], s.particles.spacing))) {
        complain(k,
                 fmt::format("{} overlaps {}; move one of them", name, s.wall_names()[2 * D + w]));
        break;
      }
    for (std::size_t j = 0; j < k; ++j)
      if (meets(samples[k], bodies[j]) || meets(samples[j], bodies[k]))
        complain(k, fmt::format("{} overlaps {}; move one of them", name, s.body_name(j)));
    const double size = body_shape(s.body[k]).extent;
    for (int d = 0; d < D; ++d)
      if (const auto j = std::size_t(d);
          free && s.periodic(d) &&
          size + 2 * support_radius(s) > s.domain.max[j] - s.domain.min[j]) {
        complain(k, fmt::format("{} is {:.4g} m across, too large for a domain that is periodic "
                                "after {:.4g} m in {}: it would interact with its own image; make "
                                "it smaller",
                                name, size, s.domain.max[j] - s.domain.min[j], axis_names[d]));
        break;
      }
  }
  return good;
}

}  // namespace

bool check_body_places(const Scene& s, bool walls_are_good, Findings& out) {
  return s.dimension() == 2 ? check_places<2>(s, walls_are_good, out)
                            : check_places<3>(s, walls_are_good, out);
}

}  // namespace freshet

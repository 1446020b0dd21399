// SPDX-License-Identifier: MIT
#include "sim/look.h"

#include <cmath>
#include <limits>
#include <vector>

#include "scene/sample/region_surface.h"

namespace freshet {
namespace {

/// Where a particle is, as seen from the domain.
enum class Place { inside, beyond_open, beyond_wall };

template <int D> class Looker {
 public:
  Looker(const Scene& s, const Derived& d)
      : min_(s.domain.min),
        max_(s.domain.max),
        gravity_(vec_of<D>(s.domain.gravity)),
        far_(10 * norm(vec_of<D>(max_) - vec_of<D>(min_))),
        support_(d.support_radius),
        rest_density_(d.rest_density) {
    for (const Scene::Liquid& liquid : s.liquids())
      heaviness_.push_back(liquid.rest_density / d.rest_density);
    for (int side = 0; side < 2 * D; ++side) open_[std::size_t(side)] = s.is_open(side);
    for (const Scene::Wall& wall : s.wall)
      if (wall.shape != Shape::points) walls_.emplace_back(wall, s.particles.spacing);
  }

  Look operator()(const ParticleView& f) const {
    Look look;
    const std::size_t n = f.size();
    if (n == 0) return look;
    const Vec<D, double> mean = add_up(f, look);
    double most2 = -1, agitation = 0, heaviness = 0;
    std::size_t fastest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double speed2 = norm2(at(f.v, i) - mean);
      agitation += heaviness_of(f, i) * speed2;
      heaviness += heaviness_of(f, i);
      if (!(speed2 >= most2) || (speed2 == most2 && f.id[i] > f.id[fastest])) continue;
      most2 = speed2;
      fastest = i;
    }
    look.fastest = witness(f, fastest, std::sqrt(most2));
    look.agitation = std::sqrt(agitation / heaviness);
    return look;
  }

 private:
  static Vec<D, double> at(std::span<const Real> a, std::size_t i) {
    Vec<D, double> x{};
    for (std::size_t k = 0; k < D; ++k) component(x, int(k)) = double(a[D * i + k]);
    return x;
  }
  static Witness witness(const ParticleView& f, std::size_t i, double value) {
    Witness w{f.id[i], {}, value};
    for (std::size_t k = 0; k < D; ++k) w.x[k] = f.position(i, k);
    for (double& x : w.x)
      if (std::isnan(x)) x = std::numeric_limits<double>::quiet_NaN();  // of one sign everywhere
    return w;
  }

  static Vec<D, double> position(const ParticleView& f, std::size_t i) {
    Vec<D, double> x{};
    for (std::size_t k = 0; k < D; ++k) component(x, int(k)) = f.position(i, k);
    return x;
  }

  /// Its mass over that of a particle of the densest liquid.
  double heaviness_of(const ParticleView& f, std::size_t i) const {
    return heaviness_[std::size_t(f.liquid_of(i))];
  }

  /// All but what needs the mean velocity, which it returns.
  Vec<D, double> add_up(const ParticleView& f, Look& look) const {
    const std::size_t n = f.size();
    Vec<D, double> momentum{};
    double heaviness = 0, most = 0;
    std::size_t densest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec<D, double> x = position(f, i), v = at(f.v, i);
      const double m = heaviness_of(f, i);
      const double density = double(f.density[i]) / m, excess = density / rest_density_ - 1;
      heaviness += m;
      if (excess > 0) {
        look.density_error += excess;
        look.compression += excess * excess;
      }
      if (i == 0 || density > most || (density == most && f.id[i] < f.id[densest])) {
        densest = i;
        most = density;
      }
      const double speed2 = norm2(v), height = dot(gravity_, x);
      look.kinetic += m * speed2 / 2;
      look.potential -= m * height;
      momentum += m * v;
      const bool number = std::isfinite(speed2) && std::isfinite(norm2(x)) && std::isfinite(excess);
      const Place where = place(x, support_);
      const bool beyond = where == Place::beyond_wall;
      if (!number || (beyond && place(x, far_) == Place::beyond_wall)) lose(f, i, number, look);
      else if (beyond || (where == Place::inside && is_in_wall(x))) leave(f, i, look);
    }
    look.densest = witness(f, densest, most);
    for (double* sum : {&look.density_error, &look.compression}) *sum /= double(n);
    for (double* sum : {&look.kinetic, &look.potential}) *sum /= heaviness;
    return momentum / heaviness;
  }

  Place place(Vec<D, double> x, double margin) const {
    Place found = Place::inside;
    for (std::size_t k = 0; k < D; ++k) {
      const double along = component(x, int(k));
      const bool low = along < min_[k] - margin;
      if (!low && !(along > max_[k] + margin)) continue;
      if (open_[2 * k + !low]) return Place::beyond_open;
      found = Place::beyond_wall;
    }
    return found;
  }
  bool is_in_wall(Vec<D, double> x) const {
    for (const auto& wall : walls_)
      if (wall.distance(x) < -support_) return true;
    return false;
  }
  static void lose(const ParticleView& f, std::size_t i, bool number, Look& look) {
    if (!look.lost || f.id[i] < look.lost->id) look.lost = witness(f, i, !number);
  }
  static void leave(const ParticleView& f, std::size_t i, Look& look) {
    if (look.left++ == 0 || f.id[i] < look.first_left.id) look.first_left = witness(f, i, 1);
  }

  Vector min_, max_;
  Vec<D, double> gravity_;
  double far_, support_, rest_density_;
  std::vector<double> heaviness_;  // of the liquids
  std::array<bool, 2 * D> open_{};
  std::vector<RegionSurface<D>> walls_;
};

}  // namespace

std::function<Look(const ParticleView&)> look_at(const Scene& scene, const Derived& derived) {
  if (scene.dimension() == 2) return Looker<2>(scene, derived);
  return Looker<3>(scene, derived);
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>

#include "scene/model/expressions.h"
#include "scene/sample/hydrostatic.h"
#include "scene/sample/places.h"
#include "scene/sample/sample_bodies.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

template <int D> class FluidSampler {
 public:
  explicit FluidSampler(const Scene& s)
      : s_(s),
        jitter_(float(s.particles.jitter)),  // a float: a double build has the same offsets
        generator_(static_cast<std::mt19937::result_type>(s.particles.seed)),
        offset_(-jitter_, jitter_),
        tells_pressure_(s.method().incompressible() &&
                        std::any_of(s.fluid.begin(), s.fluid.end(),
                                    [](const Scene::Fluid& f) {
                                      return f.pressure == StartPressure::hydrostatic;
                                    })),
        several_liquids_(s.liquids().size() > 1),
        weight_(s) {}

  void add(std::size_t number, Sample& all) {
    const Scene::Fluid& f = s_.fluid[number];
    const Places<D> places(s_, f);
    const Vec<D> velocity = vec_of<D, Real>(f.velocity);
    std::vector<Vec<D>> x;
    all.left_out += places.each([&](Vec<D> place, std::size_t i) {
      x.push_back(place);
      append(all.v, places.velocities().empty() ? velocity : places.velocities()[i]);
      return true;
    });
    Expressions field(f.velocity_field);
    for (std::size_t i = 0; i < x.size(); ++i) {
      Vec<D>& a = x[i];
      shake(a);
      const auto [compression, pressure] = weight_.settle(number, a);
      all.density.push_back(Real(f.rest_density * compression));
      if (tells_pressure_) all.pressure.push_back(Real(pressure));
      all.outside += is_outside(a);
      if (!field.empty()) replace(all.v, all.v.size() - (x.size() - i) * D, field, a);
      append(all.x, a);
    }
    if (several_liquids_) all.liquid.resize(all.density.size(), s_.liquid_of(number));
  }

 private:
  static void append(std::vector<Real>& to, Vec<D> a) {
    for (int k = 0; k < D; ++k) to.push_back(component(a, k));
  }
  /// Replaces D numbers from v[place] on by the values of the functions at x.
  static void replace(std::vector<Real>& v, std::size_t place, Expressions& field, Vec<D> x) {
    double at[3] = {}, value[3];
    for (int k = 0; k < D; ++k) at[k] = double(component(x, k));
    field(at, 0, value);
    for (std::size_t k = 0; k < D; ++k) v[place + k] = Real(value[k]);
  }
  /// The last axis is drawn first, as g++ evaluates the article's arguments.
  void shake(Vec<D>& x) {
    if (jitter_ > 0)
      for (int k = D - 1; k >= 0; --k) component(x, k) += offset_(generator_);
  }
  bool is_outside(Vec<D> x) const {
    for (int k = 0; k < D; ++k) {
      const auto j = std::size_t(k);
      if (component(x, k) < s_.domain.min[j] || component(x, k) > s_.domain.max[j]) return true;
    }
    return false;
  }

  const Scene& s_;
  float jitter_;
  std::mt19937 generator_;
  std::uniform_real_distribution<float> offset_;
  bool tells_pressure_, several_liquids_;
  Hydrostatic<D> weight_;
};

template <int D> Sample sample_in(const Scene& s) {
  Sample all;
  FluidSampler<D> sampler(s);
  for (std::size_t k = 0; k < s.fluid.size(); ++k) sampler.add(k, all);
  sample_walls<D>(s, all);
  sample_bodies<D>(s, all);
  return all;
}

}  // namespace

Sample sample(const Scene& scene) {
  const Scene s = with_defaults(scene);
  return s.dimension() == 2 ? sample_in<2>(s) : sample_in<3>(s);
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "scene/check/findings.h"
#include "scene/model/expressions.h"
#include "scene/sample/fill.h"
#include "scene/sample/hydrostatic.h"
#include "scene/sample/places.h"
#include "scene/sample/sample_bodies.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

/// The state of a fluid under fluid.pressure_field.
class StartPressureField {
 public:
  StartPressureField(const Scene& s, const Scene::Fluid& f)
      : s_(s),
        functions_(f.pressure_field.empty() ? std::vector<std::string>()
                                            : std::vector{f.pressure_field}),
        function_(functions_, s.dimension() == 3 ? "xyz" : "xy") {}

  /// At x. Throws Error at `place` if the pressure is invalid.
  template <int D> HydrostaticState operator()(Vec<D, double> x, const std::string& place) {
    double at[3] = {}, p = 0;
    for (int k = 0; k < D; ++k) at[k] = component(x, k);
    function_(at, 0, &p);
    if (const auto error = not_finite(functions_, "fluid.pressure_field", at, {}, &p, D))
      throw Error(Error::Kind::scene, place, *error);
    if (const double compression = compression_at(s_, p); compression > 0) return {compression, p};
    throw Error(Error::Kind::scene, place,
                fmt::format("fluid.pressure_field is {:.4g} Pa, so far below 0 that no density has "
                            "it; make it larger, or the speed of sound",
                            p));
  }

 private:
  const Scene& s_;
  std::vector<std::string> functions_;
  Expressions function_;
};

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
                                      return f.pressure == StartPressure::hydrostatic ||
                                             !f.pressure_field.empty() || !f.from_run.empty();
                                    })),
        several_liquids_(s.liquids().size() > 1),
        weight_(s) {}

  /// Adds the particles of a fluid and returns their number.
  std::int64_t add(std::size_t number, Sample& all) {
    const Scene::Fluid& f = s_.fluid[number];
    const Places<D> places(s_, f);
    const Vec<D> velocity = vec_of<D, Real>(f.velocity);
    std::vector<Vec<D>> x;
    std::vector<std::size_t> point;  // of the file
    const std::int64_t left_out = places.each([&](Vec<D> place, std::size_t i) {
      x.push_back(place);
      point.push_back(i);
      append(all.v, places.velocities().empty() ? velocity : places.velocities()[i]);
      return true;
    });
    const bool cut = left_out > 0 || !f.surface.empty();
    const std::int64_t added = cut ? fill_to_walls(s_, f, places, x) : 0;
    all.left_out += std::max<std::int64_t>(0, left_out - added);
    for (std::int64_t k = 0; k < added; ++k) append(all.v, velocity);
    Expressions field(f.velocity_field), force(s_.domain.body_force);
    StartPressureField pressure_field(s_, f);
    const std::string velocity_at = place_of(s_, fmt::format("fluid[{}].velocity_field", number)),
                      pressure_at = place_of(s_, fmt::format("fluid[{}].pressure_field", number)),
                      force_at = place_of(s_, "domain.body_force");
    for (std::size_t i = 0; i < x.size(); ++i) {
      Vec<D>& a = x[i];
      shake(a);
      auto state = weight_.settle(number, a);
      if (!f.pressure_field.empty()) state = pressure_field(places.in_scene(a), pressure_at);
      double density = f.rest_density * state.compression;
      if (evolves_density(s_) && !places.densities().empty())
        density = places.densities()[point[i]];
      if (!places.pressures().empty()) state.pressure = places.pressures()[point[i]];
      all.density.push_back(Real(density));
      if (tells_pressure_) all.pressure.push_back(Real(state.pressure));
      all.outside += is_outside(places.in_scene(a));
      if (!field.empty()) {
        const auto v = values(field, f.velocity_field, {}, "fluid.velocity_field", velocity_at,
                              places.in_scene(a));
        std::transform(v.begin(), v.end(), all.v.end() - std::ptrdiff_t((x.size() - i) * D),
                       [](double k) { return Real(k); });
      }
      if (!force.empty())
        values(force, s_.domain.body_force, 0, "domain.body_force", force_at, places.in_scene(a));
      append(all.x, a);
    }
    if (several_liquids_) all.liquid.resize(all.density.size(), s_.liquid_of(number));
    return std::int64_t(x.size());
  }

 private:
  static void append(std::vector<Real>& to, Vec<D> a) {
    for (int k = 0; k < D; ++k) to.push_back(component(a, k));
  }
  /// The values of a key's functions at a place at the start. Throws if one is not finite.
  std::array<double, D> values(Expressions& of, const std::vector<std::string>& functions,
                               std::optional<double> t, const char* key, const std::string& place,
                               Vec<D, double> x) const {
    double at[3] = {};
    std::array<double, D> value{};
    for (int k = 0; k < D; ++k) at[k] = component(x, k);
    of(at, 0, value.data());
    if (const auto error = not_finite(functions, key, at, t, value.data()))
      throw Error(Error::Kind::scene, place, *error);
    return value;
  }
  /// The last axis is drawn first, as g++ evaluates the article's arguments.
  void shake(Vec<D>& x) {
    if (jitter_ > 0)
      for (int k = D - 1; k >= 0; --k) component(x, k) += offset_(generator_);
  }
  bool is_outside(Vec<D, double> x) const {
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

template <int D> Sample sample_in(const Scene& s, Counts& of_fluids) {
  Sample all;
  FluidSampler<D> sampler(s);
  for (std::size_t k = 0; k < s.fluid.size(); ++k) of_fluids.push_back(sampler.add(k, all));
  sample_walls<D>(s, all);
  sample_bodies<D>(s, all);
  return all;
}

}  // namespace

Sample sample(const Scene& scene, Counts* of_fluids) {
  const Scene s = with_defaults(scene);
  Counts counts;
  const Sample all = s.dimension() == 2 ? sample_in<2>(s, counts) : sample_in<3>(s, counts);
  if (of_fluids) *of_fluids = counts;
  return all;
}

}  // namespace freshet

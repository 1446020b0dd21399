// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "scene/places.h"
#include "scene/sample_walls.h"

namespace freshet {
namespace {

/// A column of fluid under its own weight: where its layers come to rest, and how dense.
/// With the pressure rho0 g s below a depth s of material (so much of it if it were uncompressed):
///   mueller2003        rho/rho0 = 1 + g s/k
///   wcsph, delta_sph   rho/rho0 = (1 + 7 g s/c²)^(1/7)   [Tait's equation]
///   pcisph, iisph, dfsph, pbf   rho = rho0
/// A layer stands above the bottom by the integral of rho0/rho ds up to it.
class HydrostaticColumn {
 public:
  HydrostaticColumn(const Scene& s, double gravity, double height)
      : rigid_(s.solver.incompressible()),
        tait_(s.solver.name != SolverName::mueller2003),
        per_depth_(rigid_ ? 0 : (tait_ ? 7 : 1) * gravity / stiffness(s)),
        gravity_(gravity),
        height_(height) {}

  /// Over the rest density [m²/s²].
  double pressure(double depth) const { return gravity_ * depth; }
  double compression(double depth) const {
    const double q = 1 + per_depth_ * depth;
    return tait_ ? std::pow(q, 1.0 / 7) : q;
  }
  double height_above_bottom(double depth) const {
    if (rigid_) return height_ - depth;
    const double q = 1 + per_depth_ * depth, q_bottom = 1 + per_depth_ * height_;
    if (!tait_) return std::log(q_bottom / q) / per_depth_;
    return 7 / (6 * per_depth_) * (std::pow(q_bottom, 6.0 / 7) - std::pow(q, 6.0 / 7));
  }

 private:
  bool rigid_, tait_;
  double per_depth_, gravity_, height_;
};

/// Lets the places of a fluid sink into equilibrium.
template <int D> class Hydrostatic {
 public:
  /// `places` are those of the uncompressed lattice.
  Hydrostatic(const Scene& s, const std::vector<Vec<D>>& places)
      : down_(unit_of<D>(s.domain.gravity)),
        top_(extreme(places, 1) - s.particles.spacing / 2),
        height_(extreme(places, -1) + s.particles.spacing / 2 - top_),
        column_(s, norm(vec_of<D>(s.domain.gravity)), height_) {}

  /// Over the rest density: how dense the fluid is at a place, and its pressure [m²/s²].
  struct State {
    double compression, pressure;
  };
  /// Moves x to where its layer comes to rest; the bottom stays where it is.
  State settle(Vec<D>& x) const {
    const double depth = std::clamp(depth_of(x) - top_, 0.0, height_);
    const double sinks = height_ - depth - column_.height_above_bottom(depth);
    for (int k = 0; k < D; ++k) {
      auto step = sinks * down_;
      component(x, k) += Real(component(step, k));
    }
    return {column_.compression(depth), column_.pressure(depth)};
  }

 private:
  double depth_of(Vec<D> x) const { return dot(to_double(x), down_); }
  /// The least depth (sign 1) or the greatest (sign -1).
  double extreme(const std::vector<Vec<D>>& places, double sign) const {
    double least = INFINITY;
    for (const Vec<D>& x : places) least = std::min(least, sign * depth_of(x));
    return sign * least;
  }

  Vec<D, double> down_;
  double top_, height_;
  HydrostaticColumn column_;
};

template <int D> class FluidSampler {
 public:
  explicit FluidSampler(const Scene& s)
      : s_(s),
        jitter_(float(s.particles.jitter)),  // the same offsets in a double build
        generator_(static_cast<std::mt19937::result_type>(s.particles.seed)),
        offset_(-jitter_, jitter_),
        tells_pressure_(s.solver.incompressible() &&
                        std::any_of(s.fluid.begin(), s.fluid.end(), [](const Scene::Fluid& f) {
                          return f.pressure == StartPressure::hydrostatic;
                        })) {}

  void add(const Scene::Fluid& f, Sample& all) {
    const Places<D> places(s_, f);
    const Vec<D> velocity = vec_of<D, Real>(f.velocity);
    std::vector<Vec<D>> x;
    all.left_out += places.each([&](Vec<D> place, std::size_t i) {
      x.push_back(place);
      append(all.v, places.velocities().empty() ? velocity : places.velocities()[i]);
      return true;
    });
    std::optional<Hydrostatic<D>> weight;
    if (f.pressure == StartPressure::hydrostatic) weight.emplace(s_, x);
    for (Vec<D>& a : x) {
      shake(a);
      const auto [compression, pressure] =
          weight ? weight->settle(a) : typename Hydrostatic<D>::State{1, 0};
      all.density.push_back(Real(f.rest_density * compression));
      if (tells_pressure_) all.pressure.push_back(Real(f.rest_density * pressure));
      all.outside += is_outside(a);
      append(all.x, a);
    }
  }

 private:
  static void append(std::vector<Real>& to, Vec<D> a) {
    for (int k = 0; k < D; ++k) to.push_back(component(a, k));
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
  bool tells_pressure_;
};

template <int D> Sample sample_in(const Scene& s) {
  Sample all;
  FluidSampler<D> sampler(s);
  for (const Scene::Fluid& f : s.fluid) sampler.add(f, all);
  sample_walls<D>(s, all);
  return all;
}

}  // namespace

Sample sample(const Scene& scene) {
  const Scene s = with_defaults(scene);
  return s.dimension() == 2 ? sample_in<2>(s) : sample_in<3>(s);
}

}  // namespace freshet

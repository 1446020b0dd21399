// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/cubic_spline.h"
#include "kernels/lattice_sum.h"
#include "kernels/poly6.h"
#include "kernels/spiky.h"
#include "kernels/wendland.h"
#include "scene/check/check.h"
#include "scene/model/data_bytes.h"
#include "scene/model/fastest_flow.h"
#include "scene/model/openings.h"
#include "scene/model/picture_layout.h"
#include "scene/model/schedule.h"
#include "scene/model/setup.h"
#include "scene/model/surface_bytes.h"
#include "scene/sample/fluid_volume.h"

namespace freshet {
namespace {

/// The relative error of the discrete gradient of a linear field on the lattice:
/// -sum_j dx^D x_j d/dx W(x_j) - 1. The sum is 1 in the continuum.
template <int D, class Kernel>
double gradient_error(const Kernel& W, double spacing, double support) {
  double sum = 0;
  on_lattice<D>(spacing, support,
                [&](Vec<D> x) { sum -= double(x.x) * double(W.gradient(Pair<D, Real>(x)).x); });
  for (int k = 0; k < D; ++k) sum *= spacing;
  return sum - 1;
}

template <int D> int neighbors_within(double support, double spacing) {
  const int m = int(support / spacing) + 1, mz = D == 3 ? m : 0;
  int count = -1;  // the particle itself does not count
  for (int kz = -mz; kz <= mz; ++kz)
    for (int ky = -m; ky <= m; ++ky)
      for (int kx = -m; kx <= m; ++kx)
        count += std::hypot(kx * spacing, ky * spacing, kz * spacing) < support;
  return count;
}

/// Calls f(density kernel, gradient kernel).
template <int D, class F> void with_kernels(const Scene& s, Real support, F f) {
  const auto same = [&](const auto& W) { f(W, W); };
  if (s.method().has_own_kernels()) return f(Poly6<D>(support), Spiky<D>(support));
  switch (s.solver.kernel) {
    case KernelName::cubic_spline:
      return same(CubicSpline<D>(support));
    case KernelName::wendland_c2:
      return same(WendlandC2<D>(support));
    case KernelName::wendland_c4:
      return same(WendlandC4<D>(support));
    case KernelName::wendland_c6:
      return same(WendlandC6<D>(support));
  }
}

/// Calls f(single layer) with the layer of the scene's kernel.
template <class F> void with_layer(const Scene& s, F f) {
  const double support = support_radius(s), spacing = s.particles.spacing;
  const auto layer = [&]<int D>() {
    with_kernels<D>(s, Real(support), [&]<class Kernel>(const Kernel& density, const auto&) {
      f(SingleLayer<D, Kernel>(density, spacing, support));
    });
  };
  if (s.dimension() == 2) layer.template operator()<2>();
  else layer.template operator()<3>();
}

template <int D> void derive_lattice(const Scene& s, Derived& d) {
  with_kernels<D>(s, Real(d.support_radius), [&](const auto& density, const auto& gradient) {
    d.lattice_sum = lattice_sum<D>(density, d.spacing, d.support_radius);
    d.gradient_error = gradient_error<D>(gradient, d.spacing, d.support_radius);
  });
  d.density_error = d.lattice_sum - 1;
  d.neighbors = neighbors_within<D>(d.support_radius, d.spacing);
  d.mass = d.rest_density;
  for (int k = 0; k < D; ++k) d.mass *= d.spacing;
  if (!s.particles.mass) return;
  d.mass = *s.particles.mass;
  d.lattice_sum = 1;
}

double norm_of(const Vector& a) {
  return a.size() == 3 ? std::hypot(a[0], a[1], a[2]) : std::hypot(a[0], a[1]);
}

void derive_liquids(const Scene& s, Derived& d) {
  const auto liquids = s.liquids();
  double lightest = std::numeric_limits<double>::infinity();
  for (const Scene::Liquid& l : liquids) {
    d.rest_density = std::max(d.rest_density, l.rest_density);
    lightest = std::min(lightest, l.rest_density);
  }
  d.lightness = d.rest_density / lightest;
  for (const Scene::Liquid& l : liquids)
    d.viscosity = std::max(d.viscosity, l.viscosity * (d.rest_density / l.rest_density));
}

/// The time-step limit of the explicit viscosities [s].
double viscous_step(const Scene& s, const Derived& d, double h) {
  const ViscosityMethod method = s.viscosity_method();
  double nu = method == ViscosityMethod::monaghan2005 || method == ViscosityMethod::morris1997
                  ? d.viscosity / d.rest_density
                  : 0;
  // of Monaghan's term [Monaghan 2005, sec. 3.2]: nu = alpha h c/(2 (D + 2))
  if (s.method().weakly_compressible())
    nu = std::max(
        nu, artificial_viscosity(s) * h * d.sound_speed * d.lightness / (2 * (s.dimension() + 2)));
  return 0.125 * h * h / nu;
}

void derive_steps(const Scene& s, Derived& d) {
  const TimeStepBounds bounds = bounds_at_rest(s);
  d.acoustic_step = bounds.acoustic;
  d.force_step = bounds.force;
  d.viscous_step = bounds.viscous;
  d.flow_step = bounds.flow;
  d.capillary_step = bounds.capillary;
}

/// The maximum speed at the start [m/s].
double fastest_start(const Sample& start, int dimension) {
  double fastest2 = 0;
  const auto n = std::size_t(dimension);
  for (std::size_t i = 0; i < start.v.size(); i += n) {
    double speed2 = 0;
    for (std::size_t k = 0; k < n; ++k) speed2 += square(double(start.v[i + k]));
    fastest2 = std::max(fastest2, speed2);
  }
  return std::sqrt(fastest2);
}

DerivedFluid derive_fluid(const Scene& s, const Scene::Fluid& f, std::int64_t particles) {
  DerivedFluid fluid{double(particles) * std::pow(s.particles.spacing, s.dimension()), {}};
  if (f.shape != Shape::points) fluid.asked = volume_asked(s, f);
  return fluid;
}

/// For the pressure solvers, which have no speed of sound: the flow limits the step, and the
/// nominal speed of sound is ten times the maximum speed.
void derive_flow(const Scene& s, double start, Derived& d) {
  d.density_tolerance = density_tolerance(s);
  d.divergence_tolerance = divergence_tolerance(s);
  d.sound_speed = 10 * d.fastest;
  d.stiffness = square(d.sound_speed);
  d.flow_step = 0.4 * d.support_radius / 2 / start;
}

}  // namespace

double single_layer_distance(const Scene& s) {
  double distance = 0;
  with_layer(s, [&](const auto& layer) { distance = s.particles.spacing * layer.distance(); });
  return distance;
}

double single_layer_volume(const Scene& s, double distance) {
  double factor = 0;
  with_layer(
      s, [&](const auto& layer) { factor = layer.volume_factor(distance / s.particles.spacing); });
  return factor;
}

double support_radius(const Scene& s) {
  return s.particles.support_radius.value_or(2 * s.particles.spacing);
}

double stiffness(const Scene& s) {
  const bool linear = s.method().pressure == PressureFamily::linear;
  if (linear) return s.solver.stiffness.value_or(100 * square(fall_through_domain(s)));
  if (s.solver.sound_speed) return square(*s.solver.sound_speed);
  return 100 * square(fastest_flow(s).speed);
}

double sound_speed(const Scene& s) { return std::sqrt(stiffness(s)); }

TimeStepBounds bounds_at_rest(const Scene& s) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Derived d{};
  derive_liquids(s, d);
  d.sound_speed = sound_speed(s);
  const double h = support_radius(s) / 2;
  TimeStepBounds b{
      s.method().incompressible() ? infinity : 0.4 * h / (d.sound_speed * std::sqrt(d.lightness)),
      0.25 * std::sqrt(h / norm_of(s.domain.gravity)), viscous_step(s, d, h)};
  if (s.solver.surface_tension_method != SurfaceTensionMethod::none)
    for (const Scene::Fluid& f : s.fluid)
      b.capillary = std::min(b.capillary, 0.25 * std::sqrt(f.rest_density * h * h * h /
                                                           (2 * double(pi) * *f.surface_tension)));
  return b;
}

Derived derive(const Scene& scene) {
  check_scene(scene);
  const Scene s = with_defaults(scene);
  Counts of_fluids;
  const Sample start = sample(s, &of_fluids);
  Derived d{};
  for (std::size_t k = 0; k < s.fluid.size(); ++k)
    d.fluids.push_back(derive_fluid(s, s.fluid[k], of_fluids[k]));
  d.particles = double(start.density.size());
  const InflowEstimate inflow = estimate_inflow(s);
  d.particles += inflow.at_start;
  d.most_particles = d.particles + inflow.later;
  for (const Scene::Inlet& in : s.inlet) {
    const InletPlan plan = inlet_plan(s, in);
    d.inlets.push_back(
        {s.flow_names()[d.inlets.size()], double(plan.particles()), plan.speed, plan.rate});
  }
  if (!s.inlet.empty())
    d.most_particles = std::max(d.particles, std::min(d.most_particles, room_in_domain(s)));
  d.outside = start.outside;
  d.left_out = start.left_out;
  for (const WallSample* w : {&start.akinci2012, &start.adami2012, &start.monaghan2009})
    d.wall_particles += std::int64_t(w->wall.size());
  d.wall_particles += std::int64_t(start.bodies.body.size());
  const Schedule schedule(s);
  d.frames = schedule.frames();
  const PictureLayout picture = picture_layout(s);
  d.picture_width = picture.width;
  d.picture_height = picture.height;
  d.data_frames = schedule.data_frames();
  d.data_bytes = double(d.data_frames) * data_bytes(s, d.most_particles);
  if (s.surface) {
    // An inlet's liquid has the surface of a cube.
    const double cube = 6 * std::cbrt(d.most_particles * d.most_particles);
    const double points = points_of_mesh(start.x, s.particles.spacing);
    d.surface_frames = schedule.surface_frames();
    d.surface_bytes = double(d.surface_frames) *
                      surface_bytes(*s.surface, s.inlet.empty() ? points : std::max(points, cube),
                                    d.most_particles);
  }
  d.spacing = s.particles.spacing;
  d.support_radius = support_radius(s);
  derive_liquids(s, d);
  if (s.dimension() == 2) derive_lattice<2>(s, d);
  else derive_lattice<3>(s, d);
  d.stiffness = stiffness(s);
  d.sound_speed = sound_speed(s);
  derive_steps(s, d);
  double fastest = fastest_start(start, s.dimension());
  for (const DerivedInlet& in : d.inlets) fastest = std::max(fastest, in.speed);
  d.fastest = std::max(fastest, fastest_flow(s).speed);
  if (s.method().incompressible()) derive_flow(s, fastest, d);
  return d;
}

double Derived::step_bound() const {
  return std::min({acoustic_step, force_step, viscous_step, flow_step, capillary_step});
}

const char* Derived::step_bound_name() const {
  const double bound = step_bound();
  return bound == force_step      ? "gravity"
         : bound == viscous_step  ? "viscosity"
         : bound == acoustic_step ? "speed of sound"
         : bound == flow_step     ? "flow"
                                  : "surface tension";
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "sim/plan_of_scene.h"

#include <algorithm>

#include "kernels/lattice_sum.h"
#include "kernels/scene_kernel.h"
#include "pairs/akinci2013.h"
#include "scene/check/findings.h"
#include "scene/model/expressions.h"
#include "scene/model/openings.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

Triple triple(const Vector& v) {
  Triple t{};
  std::copy(v.begin(), v.end(), t.begin());
  return t;
}
template <int D, class R> Triple triple(Vec<D, R> v) {
  Triple t{};
  for (int k = 0; k < D; ++k) t[std::size_t(k)] = double(component(v, k));
  return t;
}

template <int D> SolidPlan solid_plan(const Scene::Region& region) {
  const auto s = solid_of<D>(region);
  return {s.kind,   triple(s.center), triple(s.half), triple(s.axis),
          s.radius, s.half_length,    s.fluid_inside};
}

void plan_domain(const Scene& s, EnginePlan& p) {
  p.min = triple(s.domain.min);
  p.max = triple(s.domain.max);
  p.gravity = triple(s.domain.gravity);
  for (int k = 0; k < p.dimension; ++k) p.periodic[std::size_t(k)] = s.periodic(k);
  for (int side = 0; side < 2 * p.dimension; ++side)
    p.open_sides |= unsigned(s.is_open(side)) << side;
  const auto force = std::make_shared<Expressions>(s.domain.body_force);
  if (force->empty()) return;
  p.body_force = [force, functions = s.domain.body_force, place = place_of(s, "domain.body_force")](
                     const double(&x)[3], double t, double* b) {
    (*force)(x, t, b);
    if (const auto error = not_finite(functions, "domain.body_force", x, t, b))
      throw Error(Error::Kind::run, place, *error);
  };
  p.body_force_varies = force->depends_on_place();
}

/// Whether a wall of this method reflects particles. Ghosts do, should a particle cross them.
bool reflects(WallMethod method) {
  return method == WallMethod::reflection || method == WallMethod::ghost;
}

template <int D> void plan_walls(const Scene& s, EnginePlan& p) {
  p.restitution = s.walls.restitution;
  for (int side = 0; side < 2 * D; ++side) {
    p.walls.push_back({s.walls.slip == Slip::no_slip, {}});
    if (!s.periodic(side / 2) && reflects(s.side_method(side))) p.reflecting_sides |= 1u << side;
  }
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    const Scene::Wall& wall = s.wall[k];
    p.walls.push_back({wall.slip == Slip::no_slip, triple(wall.velocity)});
    if (reflects(s.wall_method(k)))
      p.reflectors.push_back({solid_plan<D>(wall), wall.restitution, 2 * D + int(k)});
  }
}

/// The plane of a side of a box, facing inwards.
CopyRulePlan mirror_at_side(const Triple& min, const Triple& max, int side, bool no_slip, int axis,
                            int wall) {
  CopyRulePlan rule;
  rule.no_slip = no_slip;
  rule.axis = axis;
  rule.point = side % 2 ? max : min;
  rule.normal[std::size_t(side / 2)] = side % 2 ? -1 : 1;
  rule.wall = wall;
  return rule;
}

/// Periodic images, and mirror images at ghost walls.
template <int D> void plan_copies(const Scene& s, EnginePlan& p) {
  for (int side = 0; side < 2 * D; ++side) {
    const auto axis = std::size_t(side / 2);
    const bool periodic = p.periodic[axis];
    if (!periodic && s.side_method(side) != WallMethod::ghost) continue;
    auto rule = mirror_at_side(p.min, p.max, side, s.walls.slip == Slip::no_slip && !periodic,
                               side / 2, periodic ? -1 : side);
    rule.mirror = !periodic;
    const double length = p.max[axis] - p.min[axis];
    if (periodic) rule.shift[axis] = side % 2 ? -length : length;
    p.copies.push_back(rule);
  }
  int axis = D;
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    if (s.wall_method(k) != WallMethod::ghost) continue;
    const Scene::Wall& wall = s.wall[k];
    const bool no_slip = wall.slip == Slip::no_slip;
    const int number = 2 * D + int(k);
    if (wall.shape == Shape::plane) {
      CopyRulePlan rule;
      rule.no_slip = no_slip;
      rule.axis = axis++;
      const auto solid = solid_of<D>(wall);
      rule.point = triple(solid.center);
      rule.normal = triple(solid.normal(solid.center));
      rule.wall = number;
      p.copies.push_back(rule);
      continue;
    }
    for (int side = 0; side < 2 * D; ++side)
      p.copies.push_back(mirror_at_side(triple(wall.min), triple(wall.max), side, no_slip,
                                        axis + side / 2, number));
    axis += D;
  }
}

template <int D> void plan_flows(const Scene& s, EnginePlan& p) {
  for (const Scene::Inlet& inlet : s.inlet) p.inlets.push_back(inlet_plan(s, inlet));
  for (const Scene::Outlet& outlet : s.outlet) p.outlets.push_back(solid_plan<D>(outlet));
  for (const Scene::Counter& counter : s.counter) {
    const Opening<D> o = opening_of<D>(counter);
    p.counters.push_back({triple(o.center), triple(o.direction), triple(o.across), triple(o.up),
                          o.half_width, o.half_height, o.radius});
  }
}

void plan_bodies(const Scene& s, EnginePlan& p) {
  p.layered_bodies = body_method(s) == WallMethod::adami2012;
  for (const Scene::Body& body : s.body) p.body_no_slip.push_back(body.slip == Slip::no_slip);
}

void plan_liquids(const Scene& s, const Derived& d, EnginePlan& p) {
  p.rest_density = d.rest_density;
  p.lightness = d.lightness;
  p.viscosity = d.viscosity;
  // All fluids have the same; the check of forces requires a fluid.
  const double sigma = s.fluid.empty() ? 0 : s.fluid[0].surface_tension.value_or(0);
  const double unit = d.rest_density * d.support_radius * d.support_radius;
  const double gamma = (p.dimension == 2 ? akinci2013_gamma<2> : akinci2013_gamma<3>)*sigma / unit;
  for (const Scene::Liquid& liquid : s.liquids())
    p.liquids.push_back({liquid.rest_density, liquid.viscosity, sigma, gamma,
                         s.fluid.empty() ? 0 : gamma * s.fluid[0].adhesion});
}

template <int D> void plan_pressure(const Scene& s, const Derived& d, EnginePlan& p) {
  const Scene::Solver& solver = s.solver;
  p.sound_speed = d.sound_speed;
  p.stiffness = d.stiffness;
  if (solver.speed_limit) p.speed_limit = *solver.speed_limit;
  p.background_pressure = solver.background_pressure;
  p.artificial_viscosity = artificial_viscosity(s);
  const DensityDiffusion diffusion = s.density_diffusion();
  p.density_diffusion = diffusion == DensityDiffusion::none ? 0 : solver.delta;
  p.acoustic_damping = solver.acoustic_damping;
  p.antuono2010 = diffusion == DensityDiffusion::antuono2010;
  if (!p.incompressible) return;
  // other methods than its own are forces outside of the solver
  if (s.viscosity_method() == ViscosityMethod::monaghan2005)
    p.own_viscosity = d.viscosity / d.rest_density;
  p.xsph = solver.xsph;
  p.xsph_time = std::isfinite(d.force_step) ? d.force_step : 0;
  const SceneKernel<D> W(Real(p.support), p.kernel);
  p.lattice_response = lattice_response<D>(W, p.spacing, p.support);
  p.lattice_stiffness = lattice_stiffness<D>(W, p.spacing, p.support);
  p.warm_start = solver.warm_start;
  p.accelerated = solver.iteration == Iteration::nesterov;
  p.gradual = corrects_gradually(s);
  p.surface_deficit = surface_deficit<D>(W, p.spacing, p.support);
  const int least = int(solver.min_iterations.value_or(1)), most = int(solver.max_iterations);
  p.density = {d.density_tolerance, least, most};
  p.divergence = {d.divergence_tolerance, least, most};
  p.divergence_at_rest = {d.divergence_tolerance, solver.min_iterations ? least : std::min(4, most),
                          most};
}

template <int D> void plan_forces(const Scene& s, const Derived& d, EnginePlan& p) {
  ForcesPlan& f = p.forces;
  if (!s.method().has_boundary_particles()) return;
  const ViscosityMethod viscosity = s.viscosity_method();
  const bool own = p.incompressible && viscosity == ViscosityMethod::monaghan2005;
  if (!own) f.viscosity = viscosity;
  f.tension = s.solver.surface_tension_method;
  f.shifting = s.solver.shifting_method;
  f.vorticity = s.solver.vorticity_method;
  f.drag = s.air.drag;
  if (!f.any()) return;
  f.vorticity_transfer = s.solver.vorticity_transfer.value_or(0);
  f.vorticity_inertia = s.solver.vorticity_inertia.value_or(p.support * p.support);
  f.implicit = {s.solver.viscosity_tolerance, 0, int(s.solver.viscosity_max_iterations)};
  f.air_density = s.air.density;
  f.air_viscosity = s.air.viscosity;
  f.air_velocity = triple(s.air.velocity);
  const SceneKernel<D> W(Real(p.support), p.kernel);
  Vec<D> apart{};
  apart.x = Real(p.spacing);
  f.W_spacing = double(W(Pair<D, Real>(apart)));
  f.mean_depth = mean_distance<D>(W, p.support) * (D == 2 ? 2 / double(pi) : 0.5);
  f.neighbors = d.neighbors;
  f.no_walls = s.wall.empty();
  for (int side = 0; side < 2 * D; ++side) f.no_walls &= s.periodic(side / 2) || s.is_open(side);
}

/// Limits that are not set are shares of the maximum speed that the scene lets expect.
void plan_whitewater(const Scene& s, const Derived& d, EnginePlan& p) {
  if (!s.whitewater) return;
  const Scene::Whitewater& from = *s.whitewater;
  const auto limits = [](const Vector& set, double low, double high) {
    return set.empty() ? std::array{low, high} : std::array{set[0], set[1]};
  };
  WhitewaterPlan& w = p.whitewater;
  w.active = true;
  w.trapped_air = from.trapped_air;
  w.wave_crest = from.wave_crest;
  w.turbulence = from.turbulence;
  w.trapped_limits = limits(from.trapped_air_limits, 0.1 * d.fastest, 0.4 * d.fastest);
  w.crest_limits = limits(from.wave_crest_limits, 0.2, 0.8);
  w.turbulence_limits = limits(from.turbulence_limits, 0.1 * d.fastest, 0.4 * d.fastest);
  w.speed_limits = limits(from.speed_limits, 0.15 * d.fastest, 0.5 * d.fastest);
  w.life_min = from.lifetime[0];
  w.life_max = from.lifetime[1];
  w.buoyancy = from.buoyancy;
  w.rise_speed = from.rise_speed;
  w.neighbors = d.neighbors;
  w.most = std::int64_t(d.whitewater(s));
  w.seed = std::uint64_t(from.seed);
}

/// Makes the positions of a plan relative to its origin.
void move_to_origin(EnginePlan& p) {
  const Triple origin = p.origin;
  const auto move = [&](Triple& x) {
    for (std::size_t k = 0; k < 3; ++k) x[k] -= origin[k];
  };
  move(p.min);
  move(p.max);
  for (ReflectorPlan& reflector : p.reflectors) move(reflector.solid.center);
  for (CopyRulePlan& rule : p.copies) move(rule.point);
  for (SolidPlan& outlet : p.outlets) move(outlet.center);
  for (OpeningPlan& counter : p.counters) move(counter.center);
  for (InletPlan& inlet : p.inlets)
    for (std::size_t k = 0; k < inlet.places.size(); ++k)
      inlet.places[k] -= origin[k % std::size_t(p.dimension)];
  if (!p.body_force) return;
  p.body_force = [b = std::move(p.body_force), origin](const double(&x)[3], double t, double* out) {
    const double in_scene[3] = {origin[0] + x[0], origin[1] + x[1], origin[2] + x[2]};
    b(in_scene, t, out);
  };
}

template <int D> void plan_all(const Scene& s, const Derived& d, EnginePlan& p) {
  plan_liquids(s, d, p);
  plan_pressure<D>(s, d, p);
  plan_domain(s, p);
  plan_walls<D>(s, p);
  plan_copies<D>(s, p);
  plan_flows<D>(s, p);
  plan_bodies(s, p);
  plan_forces<D>(s, d, p);
  plan_whitewater(s, d, p);
}

/// The skin of neighbour lists that serve several steps [m]: a tenth of the support. The solvers
/// with an equation of state take many short steps. Pairs beyond the support add exactly zero to
/// their sums, but other forces count neighbours, bodies are listed anew in each step, and a
/// particle that crosses a periodic border has left its lists.
double skin_of(const Scene& s, const EnginePlan& p) {
  const bool short_steps = !p.incompressible && !s.method().has_own_kernels();
  const bool periodic = p.periodic[0] || p.periodic[1] || p.periodic[2];
  return short_steps && !p.bodies && !p.forces.any() && !periodic ? 0.1 * p.support : 0;
}

}  // namespace

EnginePlan plan_of(const Scene& s, const Derived& d, Bodies* bodies, int threads) {
  EnginePlan p;
  p.bodies = bodies;
  p.dimension = s.dimension();
  p.threads = threads;
  p.solver = s.solver.name;
  p.incompressible = s.method().incompressible();
  p.predicts_places = s.method().predicts_places;
  p.kernel = s.solver.kernel;
  p.integrator = s.integrator();
  p.search = s.solver.search;
  p.neighbor_order = s.solver.neighbor_order;
  p.article = s.is_article();
  p.support = d.support_radius;
  p.h = s.method().has_own_kernels() ? p.support : p.support / 2;
  p.spacing = d.spacing;
  p.mass = d.mass;
  p.lattice_sum = d.lattice_sum;
  if (p.dimension == 2) plan_all<2>(s, d, p);
  else plan_all<3>(s, d, p);
  p.skin = skin_of(s, p);
  p.origin = origin_of(s);
  if (p.origin != Triple{}) move_to_origin(p);
  p.sample = sample(s);
  return p;
}

}  // namespace freshet

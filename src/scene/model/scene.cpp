// SPDX-License-Identifier: MIT
/// Member functions of Scene, and the defaults that depend on the dimension.
#include "freshet/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/model/loaded_mesh.h"
#include "scene/model/run_frame.h"
#include "scene/model/setup.h"

namespace freshet {
std::int64_t Scene::steps() const {
  return time.adaptive ? std::int64_t(std::ceil(time.end / time.step_max.value_or(time.end)))
                       : std::llround(time.end / time.step);
}

namespace {

/// Points and meshes with holes bound no solid that could hold layers of boundary particles.
bool holds_layers(const Scene::Wall& w) {
  return w.shape != Shape::points &&
         (w.shape != Shape::mesh || !w.loaded || w.loaded->condition.closed());
}

}  // namespace

WallMethod Scene::side_method(int side) const {
  const std::optional<WallMethod> given[] = {walls.x_min, walls.x_max, walls.y_min,
                                             walls.y_max, walls.z_min, walls.z_max};
  return given[side].value_or(walls.method.value_or(method().walls));
}

WallMethod Scene::wall_method(std::size_t k) const {
  const WallMethod usual = method().walls;
  const bool too_thin = usual == WallMethod::adami2012 && !holds_layers(wall[k]);
  return wall[k].method.value_or(too_thin ? WallMethod::akinci2012 : usual);
}

Integrator Scene::integrator() const { return time.integrator.value_or(method().integrator); }

std::vector<Scene::Liquid> Scene::liquids() const {
  std::vector<Liquid> all;
  const auto add = [&](const Liquid& liquid) {
    if (std::find(all.begin(), all.end(), liquid) == all.end()) all.push_back(liquid);
  };
  for (const Fluid& f : fluid) add({f.rest_density, f.viscosity, f.color});
  for (std::size_t k = 0; k < inlet.size(); ++k) add(inlet_liquid(k));
  const Fluid none;
  if (all.empty()) add({none.rest_density, none.viscosity, none.color});
  return all;
}

Scene::Liquid Scene::inlet_liquid(std::size_t k) const {
  const Fluid none, &first = fluid.empty() ? none : fluid[0];
  const Inlet& in = inlet[k];
  return {in.rest_density.value_or(first.rest_density), in.viscosity.value_or(first.viscosity),
          in.color.empty() ? first.color : in.color};
}

int Scene::liquid_of(std::size_t k) const {
  const Fluid& f = fluid[k];
  const auto all = liquids();
  const Liquid liquid{f.rest_density, f.viscosity, f.color};
  return int(std::find(all.begin(), all.end(), liquid) - all.begin());
}

DensityDiffusion Scene::density_diffusion() const {
  return solver.density_diffusion.value_or(liquids().size() > 1 ? DensityDiffusion::antuono2010
                                                                : DensityDiffusion::fourtakas2019);
}

ViscosityMethod Scene::viscosity_method() const {
  return solver.viscosity_method.value_or(method().viscosity);
}

double artificial_viscosity(const Scene& s) {
  return s.solver.artificial_viscosity.value_or(
      s.viscosity_method() == ViscosityMethod::artificial ? 0.05 : 0);
}

bool corrects_gradually(const Scene& s) {
  return s.method().reads("solver.density_correction") &&
         s.solver.density_correction.value_or(s.method().correction) == DensityCorrection::gradual;
}

bool evolves_density(const Scene& s) { return s.method().reads("solver.delta"); }

bool keeps_start_pressure(const Scene& s) {
  return evolves_density(s) || s.method().reads("solver.warm_start");
}

double density_tolerance(const Scene& s) {
  return s.solver.density_tolerance.value_or(corrects_gradually(s) ? 3e-4
                                                                   : s.method().density_tolerance);
}

double divergence_tolerance(const Scene& s) {
  return s.solver.divergence_tolerance.value_or(corrects_gradually(s) ? 3e-5 : 1e-3);
}

WallMethod body_method(const Scene& s) {
  const bool layers = s.walls.method.value_or(s.method().walls) == WallMethod::adami2012;
  return layers ? WallMethod::adami2012 : WallMethod::akinci2012;
}

bool Scene::has_flows() const {
  bool leaves = !outlet.empty();
  for (int side = 0; side < 2 * dimension(); ++side) leaves |= is_open(side);
  return leaves || !inlet.empty();
}

namespace {
constexpr const char* side_names[] = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
}

std::vector<std::string> Scene::wall_names() const {
  std::vector<std::string> names(side_names, side_names + 2 * dimension());
  for (std::size_t k = 0; k < wall.size(); ++k)
    names.push_back(wall[k].name.empty() ? fmt::format("wall[{}]", k) : wall[k].name);
  return names;
}

std::vector<std::string> Scene::flow_names() const {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, const char* kind, std::size_t k) {
    names.push_back(name.empty() ? fmt::format("{}[{}]", kind, k) : name);
  };
  for (std::size_t k = 0; k < inlet.size(); ++k) add(inlet[k].name, "inlet", k);
  for (std::size_t k = 0; k < outlet.size(); ++k) add(outlet[k].name, "outlet", k);
  for (std::size_t k = 0; k < counter.size(); ++k) add(counter[k].name, "counter", k);
  for (int side = 0; side < 2 * dimension(); ++side)
    if (is_open(side)) names.push_back(side_names[side]);
  return names;
}

const char* Scene::flow_kind(std::size_t k) const {
  if (k < inlet.size()) return "inlet";
  k -= inlet.size();
  if (k < outlet.size()) return "outlet";
  return k - outlet.size() < counter.size() ? "counter" : "open side";
}

namespace {

/// Sets the default of `up` of a rectangle.
void turn_up(Scene::Opening& o) {
  if (!o.up.empty() || o.direction.size() != 3) return;
  const double across = std::hypot(o.direction[0], o.direction[2]);
  const bool along_y = across <= 1e-6 * std::abs(o.direction[1]);
  o.up = along_y ? Vector{0, 0, 1} : Vector{0, 1, 0};
}

}  // namespace

std::string Scene::body_name(std::size_t k) const {
  return body[k].name.empty() ? fmt::format("body[{}]", k) : body[k].name;
}

Scene with_defaults(Scene s) {
  const std::size_t n = s.domain.max.size();
  if (n != 2 && n != 3) return s;
  const auto fill = [n](Vector& v, double y) {
    if (!v.empty()) return;
    v.assign(n, 0);
    v[1] = y;
  };
  fill(s.domain.min, 0);
  fill(s.domain.gravity, -9.81);
  fill(s.air.velocity, 0);
  for (Scene::Fluid& f : s.fluid) {
    fill(f.velocity, 0);
    fill(f.axis, 1);
    if (!f.surface.empty() && f.shape == Shape::box && f.min.empty() && f.max.empty()) {
      f.min = s.domain.min;
      f.max = s.domain.max;
    }
    find_run_frame(f);
  }
  for (Scene::Wall& w : s.wall) fill(w.axis, 1);
  for (Scene::Outlet& out : s.outlet) fill(out.axis, 1);
  for (Scene::Body& b : s.body) {
    fill(b.axis, 1);
    fill(b.velocity, 0);
    if (n == 3 && b.turn_axis.empty()) b.turn_axis = {0, 0, 1};
  }
  for (Scene::Joint& j : s.joint)
    if (n == 3 && j.axis.empty()) j.axis = {0, 0, 1};
  if (n == 3) {
    for (Scene::Inlet& in : s.inlet) turn_up(in);
    for (Scene::Counter& c : s.counter) turn_up(c);
  }
  for (Scene::Fluid& f : s.fluid) remember_mesh(f, n, s.particles.spacing);
  for (Scene::Wall& w : s.wall)  // a sheet keeps its holes
    remember_mesh(w, n, w.side == Side::inside ? s.particles.spacing : 0);
  for (Scene::Body& b : s.body) remember_mesh(b, n, s.particles.spacing);
  return s;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// What a scene says of itself, and the defaults that depend on its dimension.
#include "freshet/scene.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/loaded_mesh.h"
#include "scene/setup.h"

namespace freshet {
namespace {

WallMethod default_method(const Scene& s) {
  return s.solver.name == SolverName::mueller2003 ? WallMethod::reflection : WallMethod::akinci2012;
}

}  // namespace

std::int64_t Scene::steps() const {
  return time.adaptive ? std::int64_t(std::ceil(time.end / time.step_max.value_or(time.end)))
                       : std::llround(time.end / time.step);
}

WallMethod Scene::side_method(int side) const {
  const std::optional<WallMethod> given[] = {walls.x_min, walls.x_max, walls.y_min,
                                             walls.y_max, walls.z_min, walls.z_max};
  return given[side].value_or(walls.method.value_or(default_method(*this)));
}

WallMethod Scene::wall_method(std::size_t k) const {
  return wall[k].method.value_or(default_method(*this));
}

Integrator Scene::integrator() const {
  return time.integrator.value_or(solver.name == SolverName::wcsph ? Integrator::symplectic_euler
                                                                   : Integrator::leapfrog);
}

double density_tolerance(const Scene& s) {
  return s.solver.density_tolerance.value_or(s.solver.name == SolverName::dfsph ? 1e-4 : 1e-3);
}

std::vector<std::string> Scene::wall_names() const {
  static constexpr const char* sides[] = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
  std::vector<std::string> names(sides, sides + 2 * dimension());
  for (std::size_t k = 0; k < wall.size(); ++k)
    names.push_back(wall[k].name.empty() ? fmt::format("wall[{}]", k) : wall[k].name);
  return names;
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
  for (Scene::Fluid& f : s.fluid) {
    fill(f.velocity, 0);
    fill(f.axis, 1);
  }
  for (Scene::Wall& w : s.wall) fill(w.axis, 1);
  if (n == 3) {
    for (Scene::Fluid& f : s.fluid) remember_mesh(f);
    for (Scene::Wall& w : s.wall) remember_mesh(w);
  }
  return s;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "methods/solver_methods.h"

#include <algorithm>

namespace freshet {
namespace {

/// In the order of SolverName.
const std::vector<SolverMethod>& all() {
  static const std::vector<SolverMethod> methods{
      mueller2003_method(), wcsph_method(), delta_sph_method(), pcisph_method(),
      iisph_method(),       dfsph_method(), pbf_method()};
  return methods;
}

}  // namespace

SolverMethod weakly_compressible_method() {
  SolverMethod m{};
  m.pressure = PressureFamily::tait;
  m.keys = {"solver.kernel", "solver.sound_speed", "solver.artificial_viscosity",
            "solver.background_pressure", "time.integrator"};
  m.instead = {{"solver.scheme", "has one scheme"},
               {"solver.speed_limit", "has none"},
               {"solver.stiffness", "has solver.sound_speed instead"}};
  m.viscosity = ViscosityMethod::artificial;
  m.walls = WallMethod::adami2012;
  return m;
}

SolverMethod incompressible_method() {
  SolverMethod m{};
  m.pressure = PressureFamily::incompressible;
  m.solves = {"density"};
  m.keys = {"solver.kernel",         "solver.density_tolerance",
            "solver.min_iterations", "solver.max_iterations",
            "solver.xsph",           "time.retry"};
  m.instead = {
      {"solver.scheme", "has one scheme"},
      {"solver.speed_limit", "has none"},
      {"solver.stiffness", "solves for the pressure, without an equation of state"},
      {"solver.sound_speed", "solves for the pressure, without sound"},
      {"solver.background_pressure", "solves for the pressure, without an equation of state"},
      {"solver.artificial_viscosity", "has fluid.viscosity instead"},
      {"time.integrator", "has an integrator of its own"}};
  m.density_tolerance = 1e-3;
  return m;
}

bool SolverMethod::reads(std::string_view key) const {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

const SolverMethod& method_of(SolverName solver) { return all()[std::size_t(solver)]; }

const std::vector<const SolverMethod*>& solver_methods() {
  static const std::vector<const SolverMethod*> pointers = [] {
    std::vector<const SolverMethod*> list;
    for (const SolverMethod& m : all()) list.push_back(&m);
    return list;
  }();
  return pointers;
}

}  // namespace freshet

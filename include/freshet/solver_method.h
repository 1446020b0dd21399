// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <utility>
#include <vector>

#include "freshet/methods.h"
#include "freshet/time_step.h"

namespace freshet {

/// How a solver gets its pressure.
enum class PressureFamily {
  linear,         ///< p = k(rho - rho0); the kernels of its paper; walls without boundary particles
  tait,           ///< Tait's equation of state: weakly compressible
  incompressible  ///< solves for the pressure in each step
};

/// What a solver says of itself. Checks, defaults, documentation, observables and the engine read
/// this, and no name of a solver.
struct SolverMethod {
  SolverName solver;
  const char* name;   ///< in scenes and reports
  const char* paper;  ///< authors and year
  PressureFamily pressure;
  /// Its solves, in the order of a step.
  std::vector<const char*> solves;
  /// The scene keys that this solver reads and another one does not.
  std::vector<std::string_view> keys;
  /// Keys of other solvers, and what this one has in their place.
  std::vector<std::pair<std::string_view, const char*>> instead;

  // Defaults of keys that are not set.
  Integrator integrator = Integrator::leapfrog;
  ViscosityMethod viscosity = ViscosityMethod::monaghan2005;
  WallMethod walls = WallMethod::akinci2012;
  /// Of solver.density_correction, where it is read.
  DensityCorrection correction = DensityCorrection::at_once;
  double density_tolerance = 0;  ///< maximum of the mean of max(0, rho/rho0 - 1)

  /// Moves the particles before it solves: forces on bodies act at the end of a step.
  bool predicts_places = false;

  bool incompressible() const { return pressure == PressureFamily::incompressible; }
  bool weakly_compressible() const { return pressure == PressureFamily::tait; }
  /// Whether it sums over boundary particles, knows several liquids and forces beside pressure.
  bool has_boundary_particles() const { return pressure != PressureFamily::linear; }
  bool has_own_kernels() const { return pressure == PressureFamily::linear; }
  bool reads(std::string_view key) const;
};

const SolverMethod& method_of(SolverName solver);
/// All solvers, in the order of SolverName.
const std::vector<const SolverMethod*>& solver_methods();

}  // namespace freshet

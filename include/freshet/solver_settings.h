// SPDX-License-Identifier: MIT
/// The settings of the solver of a scene.
#pragma once
#include <cstdint>
#include <optional>

#include "freshet/methods.h"

namespace freshet {

/// docs/scene.md documents every key of [solver] with its unit, default, range and source; members
/// and keys have the same names. A comment names the solvers that use the members.
struct SolverSettings {
  SolverName name = SolverName::mueller2003;
  Scheme scheme = Scheme::paper;
  BackendName backend = BackendName::cpu;
  Search search = Search::grid;
  NeighborOrder neighbor_order = NeighborOrder::cell;
  std::optional<double> stiffness, speed_limit;       // mueller2003
  KernelName kernel = KernelName::cubic_spline;       // all but mueller2003
  std::optional<double> sound_speed;                  // wcsph, delta_sph
  std::optional<double> artificial_viscosity;         // wcsph, delta_sph
  std::optional<DensityDiffusion> density_diffusion;  // delta_sph
  double delta = 0.1, acoustic_damping = 0;           // delta_sph
  double background_pressure = 0;                     // wcsph, delta_sph
  // The pressure solvers: pcisph, iisph, dfsph, pbf
  std::optional<double> density_tolerance;              // Derived has the default
  std::optional<double> divergence_tolerance;           // dfsph; Derived has the default
  std::optional<DensityCorrection> density_correction;  // pcisph, iisph, dfsph
  std::optional<std::int64_t> min_iterations;           // 1, or more in water almost at rest
  std::int64_t max_iterations = 100;
  bool warm_start = true;                     // iisph, dfsph
  Iteration iteration = Iteration::nesterov;  // dfsph
  double xsph = 0.1;
  // All solvers but mueller2003. Scene::viscosity_method() has the default.
  std::optional<ViscosityMethod> viscosity_method;
  double viscosity_tolerance = 0.001;           // weiler2018
  std::int64_t viscosity_max_iterations = 200;  // weiler2018
  SurfaceTensionMethod surface_tension_method = SurfaceTensionMethod::none;
  ShiftingMethod shifting_method = ShiftingMethod::none;
  VorticityMethod vorticity_method = VorticityMethod::none;
  std::optional<double> vorticity_transfer, vorticity_inertia;  // bender2017
};

}  // namespace freshet

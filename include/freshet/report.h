// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "freshet/frame.h"

namespace freshet {

/// Accumulated cost of one verb of a solver.
struct VerbTiming {
  std::string name;
  std::int64_t calls = 0;
  double seconds = 0;
  std::int64_t targets = 0;  ///< particles, summed over the calls
};

/// Summary of the state. Densities are those computed in the last step. SI units.
struct Statistics {
  std::int64_t particles = 0;
  std::int64_t out_of_bounds = 0;  ///< more than a support radius outside the domain, or NaN
  double density_mean = 0, density_min = 0, density_max = 0;
  double density_error_mean = 0, density_error_max = 0;  ///< max(0, rho/rho0 - 1), a fraction
  double speed_mean = 0, speed_max = 0;
  std::uint64_t fastest = 0;                        ///< id; the lowest of several equally fast
  double height_mean = 0;                           ///< mean of y
  double kinetic_energy = 0, potential_energy = 0;  ///< [J; J/m in 2D], potential 0 at the origin
  std::vector<double> momentum;                     ///< [kg m/s; (kg m/s)/m in 2D], one per axis
  /// About the origin [kg m²/s; (kg m²/s)/m in 2D]: about z in 2D; about x, y and z in 3D.
  std::vector<double> angular_momentum;
};

/// The time steps of a run [s], and how often each bound limited an adaptive step.
struct TimeSteps {
  double last = 0, min = 0, max = 0;
  /// Steps limited by "sound", "force", "viscosity", "flow", "surface tension" or "step_max", and
  /// by "retry" for a step that was halved
  std::map<std::string, std::int64_t> ruled;
  std::string last_ruled;    ///< bound that limited the last step; "fixed" for a fixed step
  std::int64_t retried = 0;  ///< number of steps halved because a solve did not converge
};

/// Statistics of one implicit solve over the accepted steps. Errors are fractions:
///
///   density     mean over the fluid of max(0, rho*/rho0 - 1)
///   divergence  mean over the fluid of max(0, dt Drho/Dt)/rho0
///   viscosity   norm of the residual over the norm of dt L v, with L v the viscous acceleration
///
/// Pressures that are too large push particles apart, which is an error of the other sign. If its
/// mean is larger, it is the error of a density or divergence solve.
struct SolveStatistics {
  std::string name;                  ///< "density", "divergence" or "viscosity"
  double tolerance = 0;              ///< maximum error of a converged solve
  std::int64_t solves = 0;           ///< without those of steps that were rolled back
  std::int64_t iterations = 0;       ///< total
  std::int64_t most_iterations = 0;  ///< maximum of one solve
  std::int64_t not_converged = 0;    ///< solves that ended with an error above the tolerance
  std::int64_t last_iterations = 0;
  double last_error = 0, worst_error = 0;
  double mean_iterations() const { return solves ? double(iterations) / double(solves) : 0; }
};

/// The flow through an inlet, an outlet, a counter or an open side since the start.
struct Flow {
  std::string kind, name;      ///< kind: "inlet", "outlet", "counter" or "open side"
  std::int64_t particles = 0;  ///< counter: those along its direction minus those against it
  double volume = 0;           ///< of the particles at rest density [m^3; m^2 in 2D]
  double rate = 0;             ///< [m^3/s; m^2/s in 2D], the mean since the last call of flows()
  std::int64_t waiting = 0;    ///< recycling inlet: particles that left and are not yet emitted
};

/// Pixel counts of result.png.
struct PictureStatistics {
  std::int64_t pixels = 0;
  std::int64_t bright = 0;        ///< R > 50 or G > 30
  std::int64_t bottom_third = 0;  ///< pixels in the lowest third that differ from the background
  double bright_fraction() const { return pixels ? double(bright) / double(pixels) : 0; }
};

/// The result of one key of [checks]: `value` compared with `bound`.
struct CheckResult {
  std::string name, relation;  ///< relation: "<=", "<" or ">"
  double value = 0, bound = 0;
  bool passed = false;
};

/// A warning of the health monitor. It is reported once and counted from then on.
/// docs/when_it_goes_wrong.md lists the rules and their bounds.
struct Warning {
  std::string kind;     ///< "time step", "outside", "in a wall", "density", "speed", ...
  std::string message;  ///< at the first occurrence: particle, place, time, cause and remedy
  std::int64_t first_step = 0, last_step = 0, worst_step = 0;
  double first_time = 0;         ///< [s]
  std::int64_t looks = 0;        ///< number of health checks with the warning
  double worst = 0;              ///< in the unit of `bound`
  double bound = 0;              ///< maximum without a warning: a share, or a multiple
  bool cannot_be_right = false;  ///< severe or lasting enough to make the result unphysical
};

/// The contents of report.json.
struct Report {
  /// cannot_be_right: the run reached time.end, but a warning marks its result as unphysical.
  enum class State { done, interrupted, check_failed, cannot_be_right };
  State state = State::done;
  std::string scene, title, backend, solver;
  std::int64_t steps = 0;
  double time = 0, seconds = 0;  ///< simulated time; wall time of the steps, without pictures [s]
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  std::vector<std::pair<std::string, std::vector<double>>>
      wall_forces;          ///< by name [N; N/m in 2D], at the last row of observables
  std::vector<Flow> flows;  ///< in the order of Scene::flow_names(), at the last row of observables
  std::vector<std::pair<std::string, BodyState>> bodies;  ///< by name, at the end
  Statistics statistics;
  PictureStatistics picture;
  std::vector<CheckResult> checks;
  std::vector<Warning> warnings;
  std::vector<VerbTiming> verbs;
  std::string state_sha256, kept_sha256;

  double steps_per_second() const { return seconds > 0 ? double(steps) / seconds : 0; }
  double particle_steps_per_second() const {
    return steps_per_second() * double(statistics.particles);
  }
};

/// The text of report.json.
std::string to_json(const Report& report);

}  // namespace freshet

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

/// What one verb of a solver has cost so far.
struct VerbTiming {
  std::string name;
  std::int64_t calls = 0;
  double seconds = 0;
  std::int64_t targets = 0;  ///< particles, summed over the calls
};

/// The state in a few numbers. Density is that of the last step's start. SI units.
struct Statistics {
  std::int64_t particles = 0;
  std::int64_t out_of_bounds = 0;  ///< further than a support radius outside the domain, or NaN
  double density_mean = 0, density_min = 0, density_max = 0;
  double density_error_mean = 0, density_error_max = 0;  ///< max(0, rho/rho0 - 1), a fraction
  double speed_mean = 0, speed_max = 0;
  std::uint64_t fastest = 0;                        ///< id; the least where several are as fast
  double height_mean = 0;                           ///< mean of y
  double kinetic_energy = 0, potential_energy = 0;  ///< [J]; potential zero at the origin
  std::vector<double> momentum;                     ///< [kg m/s], one number a dimension
};

/// The time steps of a run [s], and how often each bound ruled an adaptive one.
struct TimeSteps {
  double last = 0, min = 0, max = 0;
  /// "sound", "force", "viscosity", "flow", "surface tension", "step_max", and "retry" for a step
  /// that was halved
  std::map<std::string, std::int64_t> ruled;
  std::string last_ruled;    ///< what ruled the last step; "fixed" if it was given
  std::int64_t retried = 0;  ///< how often a step was halved, since a solve did not converge
};

/// What a solver that iterates has done over the steps so far. Errors are means over the fluid, as
/// fractions: of max(0, rho*/rho0 - 1), or for "divergence" of max(0, dt Drho/Dt)/rho0; or the mean
/// of what pressures hold apart beyond that, where it is more. For "viscosity" what is left of the
/// equations, as a share of what viscosity changes.
struct SolveStatistics {
  std::string name;             ///< "density", "divergence" or "viscosity"
  double tolerance = 0;         ///< of the error
  std::int64_t solves = 0;      ///< those of steps that were taken back and halved are not counted
  std::int64_t iterations = 0;  ///< in all
  std::int64_t most_iterations = 0;  ///< of one solve
  std::int64_t not_converged = 0;    ///< solves that ended beyond the tolerance all the same
  std::int64_t last_iterations = 0;
  double last_error = 0, worst_error = 0;
  double mean_iterations() const { return solves ? double(iterations) / double(solves) : 0; }
};

/// What went through an inlet, an outlet or a counter so far.
struct Flow {
  std::string kind, name;      ///< kind: "inlet", "outlet" or "counter"
  std::int64_t particles = 0;  ///< of a counter those along its direction, less those against it
  double volume = 0;           ///< of these at rest density [m^3; m^2 in 2D]
  double rate = 0;             ///< [m^3/s; m^2/s in 2D], the mean since it was last asked for
  std::int64_t waiting = 0;    ///< of an inlet that recycles: particles that left and are to come
};

/// What the result's picture holds.
struct PictureStatistics {
  std::int64_t pixels = 0;
  std::int64_t bright = 0;        ///< R > 50 or G > 30
  std::int64_t bottom_third = 0;  ///< pixels of the lowest third that differ from the background
  double bright_fraction() const { return pixels ? double(bright) / double(pixels) : 0; }
};

/// One of a scene's checks: `value` against `bound`.
struct CheckResult {
  std::string name, relation;  ///< relation: "<=", "<" or ">"
  double value = 0, bound = 0;
  bool passed = false;
};

/// Something doubtful that was seen while a run went on: told once, counted from then on. What is
/// watched, with which bounds, stands in docs/when_it_goes_wrong.md.
struct Warning {
  std::string kind;     ///< "time step", "outside", "in a wall", "density", "speed", ...
  std::string message;  ///< as first seen: what, which particle, where, when, the cause, a remedy
  std::int64_t first_step = 0, last_step = 0, worst_step = 0;
  double first_time = 0;         ///< [s]
  std::int64_t looks = 0;        ///< how many looks at the particles saw it
  double worst = 0;              ///< in the unit of `bound`
  double bound = 0;              ///< what is not doubtful yet: a share, or a multiple
  bool cannot_be_right = false;  ///< so bad, or for so long, that the run's result is no result
};

/// How a run ended, and all that report.json holds.
struct Report {
  /// cannot_be_right: it came to its end, but a warning says that its result is none.
  enum class State { done, interrupted, check_failed, cannot_be_right };
  State state = State::done;
  std::string scene, title, backend, solver;
  std::int64_t steps = 0;
  double time = 0, seconds = 0;  ///< simulated, and taken by the steps (pictures not counted)
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  std::vector<std::pair<std::string, std::vector<double>>>
      wall_forces;          ///< by name [N], as last observed
  std::vector<Flow> flows;  ///< in the order of Scene::flow_names(), as last observed
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

/// report.json.
std::string to_json(const Report& report);

}  // namespace freshet

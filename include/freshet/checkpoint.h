// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "freshet/report.h"
#include "freshet/state_array.h"

namespace freshet {

/// The state of a simulation's health monitor.
struct WatchRecord {
  struct Track {
    bool lasting, fatal;
    std::int64_t steps;  ///< number of steps with the warning
  };
  struct Particle {
    std::uint64_t id;
    std::array<double, 3> x;  ///< [m]
    double value;             ///< density [kg/m^3] or speed [m/s]
  };
  std::vector<Warning> warnings;
  std::vector<Track> tracks;  ///< one per warning
  std::int64_t steps_watched = 0;
  std::int64_t first_step = 0;  ///< step of the first health check
  /// At the first health check: mean of max(0, rho/rho0 - 1), and the time-step limit [s]
  double first_compression = 0, first_bound = 0;
  Particle first_densest{};                 ///< the densest particle at the first health check
  std::int64_t last_step = 0;               ///< step of the last health check; 0: none so far
  Particle last_fastest{};                  ///< the fastest particle at the last health check
  std::vector<std::int64_t> not_converged;  ///< SolveStatistics::not_converged of each solve
};

/// The complete state of a simulation at one time. A restored simulation continues to the same
/// bits. Boundary particles are not stored: they are sampled again from the scene.
struct Checkpoint {
  struct Array : StateArray {  ///< `data` is null; `bytes` holds the values
    std::vector<std::byte> bytes;
  };
  std::string scene;  ///< TOML with overrides; empty for a scene made in code
  std::int64_t steps = 0;
  double time = 0;      ///< [s]
  bool edited = false;  ///< Simulation::add_particles or remove_particles was called
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  /// false after a step whose halves did not converge, until a whole step converges
  bool retries_help = true;
  std::vector<Array> arrays;
  WatchRecord watch;
  std::string walls_sha256;  ///< digest of the boundary particles
};

}  // namespace freshet

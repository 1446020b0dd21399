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

/// The memory of the health monitor of a simulation.
struct WatchRecord {
  struct Track {
    bool lasting, fatal;
    std::int64_t steps;  ///< over which it was seen
  };
  struct Densest {
    std::uint64_t id;
    std::array<double, 3> x;  ///< [m]
    double value;             ///< [kg/m^D]
  };
  std::vector<Warning> warnings;
  std::vector<Track> tracks;  ///< of each warning
  std::int64_t steps_watched = 0;
  std::int64_t first_step = 0;  ///< of the first check, with its results:
  double first_compression = 0, first_bound = 0;
  Densest first_densest{};
  std::vector<std::int64_t> not_converged;  ///< of each solve, as SolveStatistics counts them
};

/// A moment of a simulation, from which it continues to the same bits: a copy of all that the next
/// steps follow from. Boundary particles are sampled anew from the scene.
struct Checkpoint {
  struct Array : StateArray {  ///< its `data` is null
    std::vector<std::byte> bytes;
  };
  std::string scene;  ///< TOML, as run; empty for a scene made in code
  std::int64_t steps = 0;
  double time = 0;      ///< [s]
  bool edited = false;  ///< Simulation::add_particles or remove_particles was called
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  bool retries_help = true;  ///< false from a step that halves did not help to one that converges
  std::vector<Array> arrays;
  WatchRecord watch;
  std::string walls_sha256;  ///< of the boundary particles
};

}  // namespace freshet

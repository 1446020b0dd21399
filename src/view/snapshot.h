// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "freshet/simulation.h"
#include "sim/probes.h"

namespace freshet::view {

/// Numbers over time.
struct SeriesOverTime {
  struct Series {
    std::string name;  ///< "speed max [m/s]"
    std::vector<float> values;
  };
  std::vector<float> times;  ///< [s]
  std::vector<Series> series;
};

/// The state that a session shows at one time. It never changes after it is published.
struct Snapshot {
  std::uint64_t number = 0;  ///< counts the snapshots of a session
  std::uint64_t run = 0;     ///< counts starts: increases when a scene is opened or restarted
  std::string name;          ///< the file of the scene or the folder of the run; empty: none
  std::shared_ptr<const Scene> scene;  ///< of the frame; null: nothing could be opened
  Frame frame;

  bool finished_run = false;                     ///< data files, not a simulation
  std::size_t frame_index = 0, frame_count = 0;  ///< of a finished run
  std::vector<double> frame_times;               ///< of its frames that were read; NaN: not yet

  std::shared_ptr<const SeriesOverTime>
      recorded;  ///< observables.csv of a finished run; may be null

  bool playing = false;
  bool ended = false;   ///< time.end, or the last frame
  bool failed = false;  ///< a step failed: only a restart helps

  // Of a simulation
  std::optional<Statistics> statistics;
  double time_step = 0;     ///< of the last step [s]
  double step_seconds = 0;  ///< wall time of a step, a running mean [s]
  int threads = 0;
  double support_radius = 0;  ///< [m]
  std::vector<SolveStatistics> solves;
  std::vector<Warning> warnings;
  std::vector<Flow> flows;
  std::vector<std::pair<std::string, double>> readings;  ///< "gauge: distance [m]" of each probe
  std::vector<Override> waiting;                         ///< changes that need a restart
  std::size_t actions = 0;                               ///< recorded since the start

  std::vector<Diagnostic> problems;  ///< of the last request or step that failed
  std::string notice;                ///< the last thing that was done: "wrote scene.toml"
  std::uint64_t notices = 0;         ///< counts them
};

}  // namespace freshet::view

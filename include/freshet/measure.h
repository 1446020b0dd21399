// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "freshet/scene.h"
#include "freshet/simulation.h"

namespace freshet {

struct MeasureOptions {
  std::filesystem::path run;  ///< the folder of a run, with its data/
  /// A TOML file with [[probe]] and [[counter]] tables, as those of a scene; if empty, those of the
  /// run's own scene.
  std::filesystem::path probes;
  std::vector<Override> overrides;  ///< of probe.* and counter.*
  bool forces = false;              ///< measures the force on each wall and body
  bool surfaces = false;            ///< writes the load on their surfaces; implies `forces`
  /// FILE.csv. If empty, RUN/measured.csv, or the first of measured-2.csv, measured-3.csv ... that
  /// does not exist.
  std::filesystem::path output;
  bool overwrite = false;  ///< replace an existing table, and what belongs to it
  Execution execution;
  /// Called after every frame with the number done and the total. Returning false stops the
  /// measurement; the frames so far are written.
  std::function<bool(std::size_t done, std::size_t all)> after_frame;
  /// Receives warnings before the first frame: data files that are missing between others, probes
  /// that measure nothing.
  std::function<void(const std::vector<Diagnostic>&)> warn;
};

struct MeasureReport {
  std::vector<std::filesystem::path> files;  ///< written; the first is the table
  std::size_t frames = 0;
  bool interrupted = false;
  double seconds = 0;  ///< total wall time
};

/// Measures a finished run at each of its data files, without simulating. A probe has the value
/// that it would have had in the run for the same state, up to the precision of the data files.
/// docs/measure.md describes the files that it writes.
///
/// Throws Error (kind scene) if the folder holds no run or no data, the file of probes or an
/// override is invalid, there is nothing to measure, the output exists (unless `overwrite`), a data
/// file is damaged or lacks a field that a measurement needs, or bodies.csv does not fit. Throws
/// Error (kind run) if a file cannot be written.
MeasureReport measure(const MeasureOptions& options);

}  // namespace freshet

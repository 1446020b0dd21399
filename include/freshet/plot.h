// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace freshet {

struct PlotOptions {
  std::filesystem::path run;  ///< the folder of a run, which may still be in progress
  /// The columns to draw, without their units: of observables.csv ("total energy" too),
  /// percentiles.csv, probes at one place ("gauge: distance") and bodies.csv ("box: y"). A name
  /// without its probe or body draws those of all. Columns with the same unit share a panel.
  /// Empty: energies, momentum, density errors, speeds, time steps and
  /// the forces on all walls where they are not always zero.
  std::vector<std::string> columns;
  /// FILE.svg, FILE.png, or a folder for observables.svg and observables.png; empty: RUN/plots.
  std::filesystem::path output;
  std::vector<std::filesystem::path> against;  ///< up to three other runs, in other line styles
};

/// Plots the tables of a run over time. Returns the files written. Existing files are
/// replaced; a failed write leaves no partial file.
///
/// Throws Error (kind scene) if the folder holds no run, the table is invalid or has no row, or a
/// column is unknown. Throws Error (kind run) if a write failed.
std::vector<std::filesystem::path> plot(const PlotOptions& options);

}  // namespace freshet

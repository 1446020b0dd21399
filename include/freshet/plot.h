// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace freshet {

struct PlotOptions {
  std::filesystem::path run;  ///< the folder of a run, which may still be going
  /// The columns of observables.csv to draw, without their units, or "total energy"; those of one
  /// unit share a panel. Empty: energies, momentum, density errors, speeds, time steps and the
  /// forces on all walls that ever feel one.
  std::vector<std::string> columns;
  /// FILE.svg, FILE.png, or a folder for observables.svg and observables.png; empty: RUN/plots.
  std::filesystem::path output;
  std::vector<std::filesystem::path> against;  ///< up to three runs to draw over it, in other lines
};

/// Draws what the observables of a run did over its time. Returns the files, each whole or absent;
/// what stood there is replaced.
///
/// Throws Error (kind scene) where there is no run, no row or no such column, or a file that is
/// no table; Error (kind run) if a write failed.
std::vector<std::filesystem::path> plot(const PlotOptions& options);

}  // namespace freshet

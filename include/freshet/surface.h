// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "freshet/error.h"
#include "freshet/frame.h"
#include "freshet/surface_settings.h"

namespace freshet {

/// A closed triangle mesh. Every edge belongs to two triangles, which run along it in opposite
/// directions. SI units.
struct SurfaceMesh {
  using Point = std::array<float, 3>;
  std::vector<Point> position;                          ///< [m]
  std::vector<Point> normal;                            ///< unit vectors, out of the fluid
  std::vector<Point> velocity;                          ///< of the fluid at the vertex [m/s]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise seen from outside
};

/// The enclosed volume [m³] and the area [m²] of a mesh.
double volume_of(const SurfaceMesh& mesh);
double area_of(const SurfaceMesh& mesh);

/// Throws Error (kind scene) at "option NAME VALUE" if a setting is out of range or not finite, or
/// if this build lacks what it needs.
void check_surface_settings(const SurfaceSettings& settings);

/// The surface of the particles of a frame in 3D. Deterministic: it has the same bits for any
/// number of threads.
///
///   spacing    of the particles [m]
///   origin     a grid point [m]; grid coordinates are measured from here
///   threads    as in freshet::render; 0: as many as the machine has
///
/// Throws Error (kind scene) if the frame is in 2D, if a setting is out of range, or if a particle
/// has a position that is not finite or more than 4·10^6 cells away from the origin.
SurfaceMesh surface_of(const Frame& frame, double spacing, const std::array<double, 3>& origin,
                       const SurfaceSettings& settings = {}, int threads = 0);

/// What make_surfaces() makes of which run.
struct SurfaceOptions : SurfaceMeshFiles {
  std::filesystem::path run;     ///< the folder of a run, with its data/
  std::filesystem::path output;  ///< folder of the surfaces; RUN/surface if empty
  bool overwrite = false;        ///< replace existing surfaces
  /// The numbers of the data files: from, from + every, ... up to `to`.
  std::int64_t from = 0, every = 1;
  std::optional<std::int64_t> to;  ///< the last one if empty
  int threads = 0;                 ///< 0: as many as the machine has
  /// Called after every data file with the number done and the total. Returning false stops;
  /// finished surfaces stay.
  std::function<bool(std::size_t done, std::size_t all)> after_surface;
  /// Receives a warning before the first surface if data files are missing between others.
  std::function<void(const std::vector<Diagnostic>&)> warn;
};

struct SurfaceReport {
  std::vector<std::filesystem::path> files;
  bool interrupted = false;
  double seconds = 0;  ///< total wall time
};

/// Writes the surfaces of the frames of a run from its data files: output/surface_0000.ply ..., or
/// surface_liquid0_0000.ply ... with `phases`. A surface has the number of its data file. A frame
/// without particles gives a mesh without triangles. For VTP, surfaces.pvd holds the times.
///
/// Throws Error (kind scene) if the folder holds no run or no data, the run is in 2D, no data file
/// has a chosen number, a surface exists (unless `overwrite`) or is the run's own, a data file is
/// damaged or a setting is out of range. Throws Error (kind run) if a file cannot be written.
SurfaceReport make_surfaces(const SurfaceOptions& options);

}  // namespace freshet

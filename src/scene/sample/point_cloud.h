// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// Points of a file, D numbers each. SI units.
struct PointCloud {
  std::vector<double> x;
  std::vector<double> v;            ///< velocities; empty if the file has none
  std::vector<std::string> unused;  ///< names of the columns that are not read
  std::vector<std::size_t> lines;   ///< of a text file, one per point
  // Of read_state only, if the file has them
  std::vector<double> density, pressure;  ///< [kg/m³], [Pa]
  std::vector<int> liquid;                ///< index among the liquids of the run
  std::optional<double> time;             ///< [s]
};

/// Reads the points of a file (formats/point_formats.h lists the formats): positions, and
/// velocities if the file has them. Other columns are skipped. In a 2D scene z must be 0. Throws
/// Error (kind scene) at FILE, or at FILE:LINE.
PointCloud read_points(const std::filesystem::path& file, int dimension);

/// Reads a frame that a run wrote: its points with density, pressure, liquid and time. Dimension 0
/// reads frames in 2D and 3D, their x and y only. Throws Error as read_points does.
PointCloud read_state(const std::filesystem::path& file, int dimension);

/// The points that a fluid of shape `points` starts with: those of its file, or the state of a run,
/// of which Scene::Fluid::liquid selects some. They are placed as region_points() does. Throws
/// Error as read_points does.
PointCloud points_of(const Scene::Fluid& fluid, int dimension);
/// Reads the points of a region's file, then scales, rotates and translates them as the region
/// says. Velocities are rotated. Throws as read_points does.
PointCloud region_points(const Scene::Region& region, int dimension);

/// Reads points from the bytes of a file. The extension of `file` selects the format; messages name
/// `file`.
PointCloud points_in(std::string_view bytes, const std::filesystem::path& file, int dimension);

}  // namespace freshet

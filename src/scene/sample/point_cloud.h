// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace freshet {

/// Points of a file, D numbers each. SI units.
struct PointCloud {
  std::vector<double> x;
  std::vector<double> v;  ///< velocities; empty where the file has none
  std::vector<std::string> unused;  ///< names of the columns that are not read
};

/// Reads the vertices of a PLY file (x, y, z and perhaps vx, vy, vz), the points of a VTP file
/// (with an array of velocities, perhaps), or the lines of a CSV file whose first line names the
/// columns. Other columns are passed over; a 2D scene takes points whose z is 0. Throws Error (kind
/// scene), at FILE:LINE where there is a line.
PointCloud read_points(const std::filesystem::path& file, int dimension);

/// The same of bytes at hand; `file` tells the format, and stands in messages.
PointCloud points_in(std::string_view bytes, const std::filesystem::path& file, int dimension);

}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace freshet {

/// What a column of points holds, by its name.
struct PointColumn {
  int component;  ///< 0 to 2: x, y, z; 3 to 5: the velocity's
  bool certain;   ///< false of u, v and w, which are a velocity only together
};

/// The column that a name stands for in the files of common programs; none if it is unknown.
/// Capitals and a unit in brackets do not matter.
std::optional<PointColumn> point_column(std::string_view name);

/// Shortens the names of components: "Points:0" to "x", "Vel.y [m/s]" to "vy". Other names are
/// unchanged.
std::string short_name(std::string_view name);

/// The rank of a name of velocity vectors, such as "velocity" or "U [m/s]": 0 is used first; none
/// of other names.
std::optional<int> velocity_rank(std::string_view name);

/// Whether arrays of this name are always velocities. A "u" can be a displacement, a "v" a volume.
bool always_velocity(std::string_view name);

}  // namespace freshet

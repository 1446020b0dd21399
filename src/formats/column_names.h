// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
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

}  // namespace freshet

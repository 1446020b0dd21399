// SPDX-License-Identifier: MIT
#include "formats/column_names.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "core/table_text.h"

namespace freshet {
namespace {

constexpr std::string_view exact[] = {"x", "y", "z", "vx", "vy", "vz"};
constexpr std::string_view letters[] = {"u", "v", "w"};
constexpr std::string_view positions[] = {"points", "point", "position", "positions",
                                          "pos",    "coord", "coords",   "coordinates"};
constexpr std::string_view velocities[] = {"velocity", "velocities", "v", "vel", "velo", "u"};
constexpr int certain_velocities = 2;

template <class List> int index_in(const List& list, std::string_view name) {
  const auto it = std::find(std::begin(list), std::end(list), name);
  return it == std::end(list) ? -1 : int(it - std::begin(list));
}

}  // namespace

std::optional<PointColumn> point_column(std::string_view name) {
  const std::string plain = plain_name(name);
  if (const int k = index_in(exact, plain); k >= 0) return PointColumn{k, true};
  if (const int k = index_in(letters, plain); k >= 0) return PointColumn{3 + k, false};
  if (plain.size() < 2) return {};
  const char last = plain.back();
  const int axis = last >= 'x' && last <= 'z' ? last - 'x' : last - '0';
  if (axis < 0 || axis > 2) return {};
  std::string_view vector = std::string_view(plain).substr(0, plain.size() - 1);
  const bool separated = std::string_view(":_. -").find(vector.back()) != std::string_view::npos;
  if (separated) vector.remove_suffix(1);
  else if (vector.size() == 1 && last < 'x') return {};  // v0 is no component
  if (index_in(positions, vector) >= 0) return PointColumn{axis, true};
  if (index_in(velocities, vector) >= 0) return PointColumn{3 + axis, true};
  return {};
}

std::string short_name(std::string_view name) {
  static constexpr const char* components[] = {"x", "y", "z", "vx", "vy", "vz"};
  const auto column = point_column(name);
  return column && column->certain ? components[column->component] : std::string(name);
}

std::optional<int> velocity_rank(std::string_view name) {
  const int rank = index_in(velocities, plain_name(name));
  if (rank < 0) return {};
  return rank;
}

bool always_velocity(std::string_view name) {
  return velocity_rank(name).value_or(certain_velocities) < certain_velocities;
}

}  // namespace freshet

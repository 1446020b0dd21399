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
constexpr std::string_view velocities[] = {"velocity", "velocities", "vel", "v", "u"};

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

}  // namespace freshet

// SPDX-License-Identifier: MIT
/// Prisms along z: solid ones, and sides in a row, such as the floor of a flume.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "import/dualsphysics.h"

namespace freshet {
namespace {

using Corner = Vec<3, double>;

/// The normal to the left of a way.
Corner left_of(const Corner& a, const Corner& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return {-(b.y - a.y) / length, (b.x - a.x) / length, 0};
}

/// Where two lines meet that are moved to the left by `first` and `second`. Corners move by at most
/// six times that.
Corner meeting(const Corner& a, double first, const Corner& b, double second) {
  const double c = a.x * b.x + a.y * b.y, square = 1 - c * c;
  if (square < 1e-4) return (0.5 * (first + second)) * (c > 0 ? a : Corner{});
  const Corner at = (1 / square) * ((first - second * c) * a + (second - first * c) * b);
  const double most = 6 * std::max(std::abs(first), std::abs(second)), length = norm(at);
  return length > most ? (most / length) * at : at;
}

/// The points with each side moved to the left by by(normal).
template <class By>
std::vector<Corner> moved_left(const std::vector<Corner>& p, By by, bool closed) {
  std::vector<Corner> out;
  const std::size_t n = p.size();
  for (std::size_t k = 0; k < n; ++k) {
    const bool first = k == 0 && !closed, last = k + 1 == n && !closed;
    const Corner a = left_of(first ? p[k] : p[(k + n - 1) % n], first ? p[k + 1] : p[k]);
    const Corner b = last ? a : left_of(p[k], p[(k + 1) % n]);
    out.push_back(p[k] + meeting(a, by(a), b, by(b)));
  }
  return out;
}

double area_of(const std::vector<Corner>& p) {
  double area = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Corner &a = p[k], &b = p[(k + 1) % p.size()];
    area += 0.5 * (a.x * b.y - b.x * a.y);
  }
  return area;
}

/// The sides that are shown, in rows.
std::vector<std::vector<Corner>> rows_of(const DsphShape& s) {
  const std::size_t n = s.points.size();
  std::size_t start = 0;  // after a hidden side
  for (std::size_t k = 0; k < n; ++k)
    if (!s.shown[(k + n - 1) % n]) start = k;
  std::vector<std::vector<Corner>> rows;
  std::vector<Corner> row;
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t k = (start + step) % n;
    if (s.shown[k]) {
      if (row.empty()) row.push_back(s.points[k]);
      row.push_back(s.points[(k + 1) % n]);
    }
    if (!row.empty() && (!s.shown[k] || step + 1 == n)) {
      rows.push_back(row);
      row.clear();
    }
  }
  return rows;
}

/// Whether the fluid is to the left of a row of sides. Without fluid: whether its upper side is.
bool fluid_is_left(const std::vector<Corner>& row, const DsphWorld& world) {
  const DsphLattice& lattice = *world.lattice;
  long left = 0, right = 0;
  double up = 0;
  for (std::size_t k = 0; k + 1 < row.size(); ++k) {
    const Corner normal = left_of(row[k], row[k + 1]), way = row[k + 1] - row[k];
    const double length = norm(way);
    up += normal.y * length;
    for (double along = 0.5 * world.dp; along < length; along += world.dp)
      for (const double away : {-3.0, -2.0, 2.0, 3.0}) {
        const Corner p = row[k] + (along / length) * way + (away * world.dp) * normal;
        const DsphLattice::Index i{lattice.nearest(0, p.x), lattice.nearest(1, p.y),
                                   lattice.counts()[2] / 2};
        if (lattice.contains(0, i[0]) && lattice.contains(1, i[1]) && lattice.at(i) > 0)
          ++(away > 0 ? left : right);
      }
  }
  return left == right ? up > 0 : left > right;
}

/// Plates along a row of sides in 3D, which has no prisms.
std::vector<TomlTable> plates_along(const std::vector<Corner>& row, const DsphShape& s,
                                    const DsphWorld& world) {
  std::vector<TomlTable> plates;
  const Bounds places = world.lattice->extent(false);
  const double z_low = std::max(s.z_low, places.low.z) - world.dp / 2,
               z_high = std::min(s.z_high, places.high.z) + world.dp / 2, depth = world.support;
  for (std::size_t k = 0; k + 1 < row.size(); ++k) {
    const Corner way = row[k + 1] - row[k], normal = left_of(row[k], row[k + 1]);
    const double half = 0.5 * norm(way) + 0.5 * depth;
    Corner center = 0.5 * (row[k] + row[k + 1]) - (depth / 2) * normal;
    center.z = 0.5 * (z_low + z_high);
    const Corner size{half, depth / 2, 0.5 * (z_high - z_low)};
    TomlTable table;
    table.set("shape", "box");
    table.set("min", center - size, 3);
    table.set("max", center + size, 3);
    table.set("rotation", {0, 0, std::atan2(way.y, way.x) * 180 / std::numbers::pi}, 3);
    plates.push_back(table);
  }
  return plates;
}

}  // namespace

std::string polygon_of(const std::vector<Corner>& points) {
  std::string text;
  for (const Corner& p : points)
    text += (text.empty() ? "[" : ", [") + toml_number(p.x) + ", " + toml_number(p.y) + "]";
  return "[" + text + "]";
}

std::vector<TomlTable> tables_of_profile(const DsphShape& s, const DsphWorld& world) {
  const bool closed = std::all_of(s.shown.begin(), s.shown.end(), [](bool b) { return b; });
  const double half = world.floating.contains(s.mk()) ? 0 : world.dp / 2;
  // Places closer to a line than half a spacing times |nx| + |ny| are on it. A side along an axis
  // has places on it, so the nearest others are a whole spacing away.
  const auto surface_of = [&](const Corner& normal) {
    const double sum = std::abs(normal.x) + std::abs(normal.y);
    return sum < 1.001 ? half : half * (sum - 1);
  };
  std::vector<TomlTable> tables;
  if (closed && world.flat() && !world.holds_fluid(s)) {
    std::vector<Corner> points = s.points;
    if (area_of(points) > 0) std::reverse(points.begin(), points.end());
    tables.emplace_back();
    tables.back().set("shape", "polygon");
    tables.back().line("points", polygon_of(moved_left(points, surface_of, true)));
    return tables;
  }
  for (std::vector<Corner> row : rows_of(s)) {
    if (!fluid_is_left(row, world)) std::reverse(row.begin(), row.end());
    const std::vector<Corner> surface = moved_left(row, surface_of, false);
    if (!world.flat()) {
      for (const TomlTable& plate : plates_along(surface, s, world)) tables.push_back(plate);
      continue;
    }
    std::vector<Corner> outline = surface,
                        behind = moved_left(
                            surface, [&](const Corner&) { return -world.support; }, false);
    outline.insert(outline.end(), behind.rbegin(), behind.rend());
    tables.emplace_back();
    tables.back().set("shape", "polygon");
    tables.back().line("points", polygon_of(outline));
  }
  return tables;
}

}  // namespace freshet

// SPDX-License-Identifier: MIT
#include "sim/near_cells.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

constexpr double most_cells = 1 << 25;

}  // namespace

NearCells::NearCells(std::size_t dimension, Point low, Point high, const TriangleMesh& mesh,
                     double near)
    : dimension_(dimension), cell_(near) {
  Point sides = high - low;
  double cells = 1;
  std::array<double, 3> length{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    length[k] = component(sides, int(k));
    cells *= length[k] / cell_ + 5;
  }
  cell_ *= std::max(1.0, std::pow(cells / most_cells, 1.0 / double(dimension_)));
  for (std::size_t k = 0; k < dimension_; ++k) {
    component(low_, int(k)) = component(low, int(k)) - 2 * cell_;
    count_[k] = std::int64_t(length[k] / cell_) + 5;
  }
  marked_.assign(std::size_t(count_[0] * count_[1] * count_[2]), 0);
  for (int t = 0; t < int(mesh.triangles.size()); ++t) mark(mesh.corners(t));
}

/// Marks the cells that are less than a cell from a triangle, and perhaps some more.
void NearCells::mark(const std::array<Point, 3>& corners) {
  const Point area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  std::array<std::int64_t, 3> first{}, last{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    std::array<double, 3> at{};
    for (std::size_t c = 0; c < 3; ++c) {
      Point offset = corners[c] - low_;
      at[c] = component(offset, int(k)) / cell_;
    }
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    const auto inside = [&](double place) {
      return std::int64_t(std::clamp(std::floor(place), 0.0, double(count_[k] - 1)));
    };
    if (*high < -1 || *low > double(count_[k] + 1)) return;
    first[k] = inside(*low - 1);
    last[k] = inside(*high + 1);
  }
  const double reach = (1 + std::sqrt(3) / 2) * cell_ * norm(area);
  for (std::int64_t z = first[2]; z <= last[2]; ++z)
    for (std::int64_t y = first[1]; y <= last[1]; ++y)
      for (std::int64_t x = first[0]; x <= last[0]; ++x) {
        Point center = low_ + cell_ * Point{double(x) + 0.5, double(y) + 0.5, double(z) + 0.5};
        if (dimension_ == 2) center.z = 0;
        if (std::abs(dot(area, center - corners[0])) <= reach)
          marked_[std::size_t((z * count_[1] + y) * count_[0] + x)] = 1;
      }
}

bool NearCells::has(Point x) const {
  Point offset = x - low_;
  std::size_t cell = 0;
  for (std::size_t k = dimension_; k-- > 0;) {
    const double at = component(offset, int(k)) / cell_;
    if (!(at >= 0 && at < double(count_[k]))) return false;
    cell = cell * std::size_t(count_[k]) + std::size_t(at);
  }
  return marked_[cell];
}

}  // namespace freshet

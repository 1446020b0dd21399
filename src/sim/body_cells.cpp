// SPDX-License-Identifier: MIT
#include "sim/body_cells.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

constexpr double most = 64;  // cells along an axis

}  // namespace

BodyCells::BodyCells(const Scene& s, double width) : dimension_(std::size_t(s.dimension())) {
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double length = s.domain.max[k] - s.domain.min[k];
    low_[k] = s.domain.min[k];
    count_[k] = std::int64_t(std::clamp(std::floor(length / width), 1.0, most));
    per_length_[k] = double(count_[k]) / length;
    periodic_[k] = s.periodic(int(k));
  }
  cells_.resize(std::size_t(count_[0] * count_[1] * count_[2]));
}

void BodyCells::clear() {
  for (auto& cell : cells_) cell.clear();
}

std::int64_t BodyCells::place(double along, std::size_t axis) const {
  constexpr double far = 1e6;  // cells; a lost particle may be anywhere, or nowhere
  const double cell = std::floor((along - low_[axis]) * per_length_[axis]);
  return std::int64_t(cell > -far ? std::min(cell, far) : -far);
}

std::int64_t BodyCells::in_grid(std::int64_t place, std::size_t axis) const {
  const std::int64_t n = count_[axis];
  return periodic_[axis] ? (place % n + n) % n : std::clamp<std::int64_t>(place, 0, n - 1);
}

void BodyCells::add(int ball, Point center, double radius) {
  std::array<std::int64_t, 3> first{}, last{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    const double x = component(center, int(k));
    first[k] = place(x - radius, k);
    last[k] = place(x + radius, k);
    if (periodic_[k]) last[k] = std::min(last[k], first[k] + count_[k] - 1);
    else first[k] = in_grid(first[k], k), last[k] = in_grid(last[k], k);
  }
  for (std::int64_t z = first[2]; z <= last[2]; ++z)
    for (std::int64_t y = first[1]; y <= last[1]; ++y)
      for (std::int64_t x = first[0]; x <= last[0]; ++x)
        cells_[std::size_t((in_grid(z, 2) * count_[1] + in_grid(y, 1)) * count_[0] + in_grid(x, 0))]
            .push_back(ball);
}

const std::vector<int>& BodyCells::at(Point x) const {
  std::size_t cell = 0;
  for (std::size_t k = dimension_; k-- > 0;) {
    const double at = (component(x, int(k)) - low_[k]) * per_length_[k];
    const bool inside = at >= 0 && at < double(count_[k]);  // as almost all are
    cell = cell * std::size_t(count_[k]) +
           std::size_t(inside ? std::int64_t(at) : in_grid(place(component(x, int(k)), k), k));
  }
  return cells_[cell];
}

}  // namespace freshet

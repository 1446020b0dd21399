// SPDX-License-Identifier: MIT
#include "sim/tight_walls.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

using Point = TriangleMesh::Point;

constexpr double most_cells = 1 << 25;

Point in_scene(const ParticleView& f, const Real* x) {
  Point at{};
  for (std::size_t k = 0; k < std::size_t(f.dimension); ++k)
    component(at, int(k)) = f.origin[k] + double(x[k]);
  return at;
}

/// Removes the part of v that points against a normal.
void stop(std::span<Real> v, Point normal) {
  double along = 0;
  for (std::size_t k = 0; k < v.size(); ++k) along += double(v[k]) * component(normal, int(k));
  if (!(along < 0)) return;
  for (std::size_t k = 0; k < v.size(); ++k) v[k] -= Real(along * component(normal, int(k)));
}

}  // namespace

TightWalls::TightWalls(const Scene& s, double support)
    : membranes_(membranes_of(s)), dimension_(std::size_t(s.dimension())) {
  if (!membranes_) return;
  double cells = 1, cell = support;
  std::array<double, 3> length{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    length[k] = s.domain.max[k] - s.domain.min[k];
    component(low_, int(k)) = s.domain.min[k];
    if (s.periodic(int(k))) period_[k] = length[k];
    cells *= length[k] / cell + 5;
  }
  cell *= std::max(1.0, std::pow(cells / most_cells, 1.0 / double(dimension_)));
  for (std::size_t k = 0; k < dimension_; ++k) {
    component(low_, int(k)) -= 2 * cell;
    count_[k] = std::int64_t(length[k] / cell) + 5;
  }
  mark_near_cells(cell);
}

void TightWalls::mark_near_cells(double cell) {
  cell_ = cell;
  near_.assign(std::size_t(count_[0] * count_[1] * count_[2]), 0);
  for (int t = 0; t < int(membranes_->mesh().triangles.size()); ++t) mark(t);
}

/// Marks the cells that are less than a cell from a triangle, and perhaps some more.
void TightWalls::mark(int triangle) {
  const auto corners = membranes_->mesh().corners(triangle);
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
          near_[std::size_t((z * count_[1] + y) * count_[0] + x)] = 1;
      }
}

bool TightWalls::is_near(Point x) const {
  std::size_t cell = 0;
  for (std::size_t k = dimension_; k-- > 0;) {
    Point offset = x - low_;
    const double at = component(offset, int(k)) / cell_;
    if (!(at >= 0 && at < double(count_[k]))) return false;
    cell = cell * std::size_t(count_[k]) + std::size_t(at);
  }
  return near_[cell];
}

void TightWalls::begin(const ParticleView& f) {
  starts_.clear();
  x_.clear();
  for (std::size_t i = 0; i < f.size(); ++i) {
    const Real* x = f.x.data() + dimension_ * i;
    if (!is_near(in_scene(f, x))) continue;
    starts_.push_back({f.id[i], x_.size()});
    x_.insert(x_.end(), x, x + dimension_);
  }
  std::sort(starts_.begin(), starts_.end());
}

std::int64_t TightWalls::hold(Engine& engine) {
  const ParticleView f = engine.fluid();
  const std::span<Real> x = engine.positions(), v = engine.velocities();
  std::int64_t stopped = 0;
  for (std::size_t i = 0; i < f.size() && !starts_.empty(); ++i) {
    const std::size_t at = dimension_ * i;
    if (!is_near(in_scene(f, x.data() + at))) continue;
    const auto start = std::lower_bound(starts_.begin(), starts_.end(), Start{f.id[i], 0});
    if (start == starts_.end() || start->id != f.id[i]) continue;
    stopped +=
        hold(f, x_.data() + start->place, x.subspan(at, dimension_), v.subspan(at, dimension_));
  }
  return stopped;
}

/// Holds one particle, which was at `before`. Returns whether its way crosses a membrane.
bool TightWalls::hold(const ParticleView& f, const Real* before, std::span<Real> x,
                      std::span<Real> v) const {
  const Point from = in_scene(f, before);
  Point way = in_scene(f, x.data()) - from;
  for (std::size_t k = 0; k < dimension_; ++k)
    if (period_[k] > 0) component(way, int(k)) = std::remainder(component(way, int(k)), period_[k]);
  const auto first = membranes_->first_crossing(from, from + way);
  if (!first) return false;
  const Point normal = normal_against(first->triangle, way);
  stop(v, normal);
  Point back = -dot(way, normal) * normal, end = from + way;
  std::array<Real, 3> slid{};
  for (std::size_t k = 0; k < dimension_; ++k) {
    slid[k] = x[k] + Real(component(back, int(k)));
    component(end, int(k)) += double(slid[k]) - double(x[k]);
  }
  if (const auto second = membranes_->first_crossing(from, end)) {
    stop(v, normal_against(second->triangle, end - from));
    std::copy_n(before, dimension_, x.begin());
  } else {
    std::copy_n(slid.begin(), dimension_, x.begin());
  }
  return true;
}

/// The unit normal of a triangle on the side that a way comes from.
Point TightWalls::normal_against(int triangle, Point way) const {
  const auto corners = membranes_->mesh().corners(triangle);
  const Point area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return (dot(area, way) < 0 ? 1 : -1) / norm(area) * area;
}

}  // namespace freshet

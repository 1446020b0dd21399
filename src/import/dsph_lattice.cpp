// SPDX-License-Identifier: MIT
#include "import/dsph_lattice.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

using LatticePoint = Vec<3, double>;

double coordinate_of(const LatticePoint& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

DsphLattice::DsphLattice(const Point& reference, const Point& low, const Point& high,
                         double spacing, int dimension)
    : origin_(low), spacing_(spacing), dimension_(dimension) {
  constexpr double slack = 1e-6;
  double* const origin[] = {&origin_.x, &origin_.y, &origin_.z};
  for (int axis = 0; axis < 3; ++axis) {
    const double from = coordinate_of(reference, axis), first = coordinate_of(low, axis),
                 last = coordinate_of(high, axis);
    if (axis == dimension) {
      counts_[2] = 1;
      break;
    }
    *origin[axis] = from + spacing * std::ceil((first - from) / spacing - slack);
    const double count = std::floor((last - *origin[axis]) / spacing + slack) + 1;
    counts_[std::size_t(axis)] = long(std::max(count, 0.0));
  }
  marks_.assign(std::size_t(counts_[0] * counts_[1] * counts_[2]), 0);
}

double DsphLattice::coordinate(int axis, long i) const {
  return coordinate_of(origin_, axis) + spacing_ * double(i);
}

DsphLattice::Point DsphLattice::place(const Index& i) const {
  return {coordinate(0, i[0]), coordinate(1, i[1]), coordinate(2, i[2])};
}

long DsphLattice::nearest(int axis, double x) const {
  return std::lround(std::floor((x - coordinate_of(origin_, axis)) / spacing_ + 0.5 + 1e-6));
}

bool DsphLattice::range_of(const Bounds& box, Index& low, Index& high) const {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = std::size_t(axis);
    const double margin = 1e6 * spacing_;  // keeps integers small
    const double first =
        std::max(coordinate_of(box.low, axis), coordinate_of(origin_, axis) - margin);
    const double last =
        std::min(coordinate_of(box.high, axis), coordinate(axis, counts_[a] - 1) + margin);
    low[a] = std::max(0L, nearest(axis, first) - 1);
    high[a] = std::min(counts_[a] - 1, nearest(axis, last) + 1);
    if (low[a] > high[a]) return false;
  }
  return true;
}

long DsphLattice::fill(const Point& seed, const Bounds& box, std::int16_t mark) {
  const double slack = 1e-6 * spacing_;
  const auto in_box = [&](const Index& i) {
    const Point p = place(i);
    for (int axis = 0; axis < dimension_; ++axis)
      if (coordinate_of(p, axis) < coordinate_of(box.low, axis) - slack ||
          coordinate_of(p, axis) > coordinate_of(box.high, axis) + slack)
        return false;
    return true;
  };
  Index start{nearest(0, seed.x), nearest(1, seed.y), dimension_ == 3 ? nearest(2, seed.z) : 0};
  for (int axis = 0; axis < 3; ++axis)
    if (!contains(axis, start[std::size_t(axis)])) return 0;
  if (at(start) != 0 || !in_box(start)) return 0;
  std::vector<Index> open{start};
  at(start) = mark;
  long filled = 1;
  while (!open.empty()) {
    const Index i = open.back();
    open.pop_back();
    for (int side = 0; side < 2 * dimension_; ++side) {
      Index next = i;
      next[std::size_t(side / 2)] += side % 2 == 0 ? 1 : -1;
      if (!contains(side / 2, next[std::size_t(side / 2)]) || at(next) != 0 || !in_box(next))
        continue;
      at(next) = mark;
      ++filled;
      open.push_back(next);
    }
  }
  return filled;
}

std::vector<DsphLattice::Block> DsphLattice::blocks(std::int16_t mark) const {
  std::vector<Block> all;
  DsphLattice rest = *this;
  const auto full = [&](const Index& first, const Index& count) {
    for (long k = 0; k < count[2]; ++k)
      for (long j = 0; j < count[1]; ++j)
        for (long i = 0; i < count[0]; ++i)
          if (rest.at({first[0] + i, first[1] + j, first[2] + k}) != mark) return false;
    return true;
  };
  for (long k = 0; k < counts_[2]; ++k)
    for (long j = 0; j < counts_[1]; ++j)
      for (long i = 0; i < counts_[0]; ++i) {
        if (rest.at({i, j, k}) != mark) continue;
        Block b{{i, j, k}, {1, 1, 1}};
        for (std::size_t axis : {std::size_t(0), std::size_t(2), std::size_t(1)})
          for (;;) {  // grows by a layer
            Index first = b.first, count = b.count;
            first[axis] += count[axis];
            count[axis] = 1;
            if (first[axis] >= counts_[axis] || !full(first, count)) break;
            ++b.count[axis];
          }
        for (long c = 0; c < b.count[2]; ++c)
          for (long d = 0; d < b.count[1]; ++d)
            for (long e = 0; e < b.count[0]; ++e) rest.at({i + e, j + d, k + c}) = 0;
        all.push_back(b);
      }
  return all;
}

Bounds DsphLattice::extent(bool fluid_only) const {
  Bounds bounds;
  for (long k = 0; k < counts_[2]; ++k)
    for (long j = 0; j < counts_[1]; ++j)
      for (long i = 0; i < counts_[0]; ++i)
        if (const std::int16_t mark = at({i, j, k}); fluid_only ? mark > 0 : mark != 0)
          bounds.add(place({i, j, k}));
  return bounds;
}

}  // namespace freshet

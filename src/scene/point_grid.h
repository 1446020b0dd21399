// SPDX-License-Identifier: MIT
#pragma once
#include <unordered_map>
#include <vector>

#include "core/cell.h"

namespace freshet {

template <int D> struct CellHash {
  std::size_t operator()(const Cell<D>& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell.c) hash = (hash ^ std::uint64_t(c)) * 0x9E3779B97F4A7C15u;
    return hash ^ hash >> 32;
  }
};

/// A hash grid of points, with cells of half a spacing: is one of them nearer than that?
template <int D> class PointGrid {
 public:
  explicit PointGrid(double spacing)
      : near2_(square(0.499 * spacing)), cell_of_(Real(spacing / 2)) {}

  void add(Vec<D> x) { cells_[cell_of_(x)].push_back(x); }
  bool empty() const { return cells_.empty(); }
  bool comes_near(Vec<D> a) const {
    const Cell<D> center = cell_of_(a);
    for (int n = 0; n < (D == 3 ? 27 : 9); ++n) {
      Cell<D> cell = center;
      cell.c[0] += n % 3 - 1;
      cell.c[1] += n / 3 % 3 - 1;
      if (D == 3) cell.c[D - 1] += n / 9 - 1;
      const auto it = cells_.find(cell);
      if (it == cells_.end()) continue;
      for (const Vec<D>& b : it->second)
        if (double(norm2(a - b)) < near2_) return true;
    }
    return false;
  }

 private:
  double near2_;
  Cells<D> cell_of_;
  std::unordered_map<Cell<D>, std::vector<Vec<D>>, CellHash<D>> cells_;
};

}  // namespace freshet

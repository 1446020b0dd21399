// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/vec.h"

namespace freshet {

/// A hash grid of points. Finds those closer than `near`.
template <int D> class PointGrid {
 public:
  explicit PointGrid(double near) : near_(near) {}

  void add(Vec<D, double> x) { cells_[cell_of(x)].push_back({x, count_++}); }
  bool empty() const { return cells_.empty(); }
  bool comes_near(Vec<D, double> a) const {
    return visit_near(a, [](int) { return true; });
  }
  /// The numbers of the points near a, in the order of cells. The first point has number 0.
  std::vector<int> near(Vec<D, double> a) const {
    std::vector<int> all;
    visit_near(a, [&](int number) {
      all.push_back(number);
      return false;
    });
    return all;
  }

 private:
  using Cell = std::array<std::int64_t, D>;
  struct Point {
    Vec<D, double> x;
    int number;
  };
  /// Calls visit for the points near a until it returns true. Returns whether it did.
  template <class Visit> bool visit_near(Vec<D, double> a, Visit visit) const {
    const Cell center = cell_of(a);
    for (int n = 0; n < (D == 3 ? 27 : 9); ++n) {
      Cell cell = center;
      cell[0] += n % 3 - 1;
      cell[1] += n / 3 % 3 - 1;
      if (D == 3) cell[D - 1] += n / 9 - 1;
      const auto it = cells_.find(cell);
      if (it == cells_.end()) continue;
      for (const Point& b : it->second)
        if (norm2(a - b.x) < near_ * near_ && visit(b.number)) return true;
    }
    return false;
  }
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t hash = 0;
      for (const std::int64_t c : cell) hash = (hash ^ std::uint64_t(c)) * 0x9E3779B97F4A7C15u;
      return hash ^ hash >> 32;
    }
  };
  Cell cell_of(Vec<D, double> x) const {
    Cell cell;
    for (int k = 0; k < D; ++k)
      cell[std::size_t(k)] =
          std::int64_t(std::floor(std::clamp(component(x, k) / near_, -1e18, 1e18)));
    return cell;
  }

  double near_;
  int count_ = 0;
  std::unordered_map<Cell, std::vector<Point>, Hash> cells_;
};

}  // namespace freshet

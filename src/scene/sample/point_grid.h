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

/// A hash grid of points. comes_near() finds whether one of them is closer than `near`.
template <int D> class PointGrid {
 public:
  explicit PointGrid(double near) : near_(near) {}

  void add(Vec<D, double> x) { cells_[cell_of(x)].push_back(x); }
  bool empty() const { return cells_.empty(); }
  bool comes_near(Vec<D, double> a) const {
    const Cell center = cell_of(a);
    for (int n = 0; n < (D == 3 ? 27 : 9); ++n) {
      Cell cell = center;
      cell[0] += n % 3 - 1;
      cell[1] += n / 3 % 3 - 1;
      if (D == 3) cell[D - 1] += n / 9 - 1;
      const auto it = cells_.find(cell);
      if (it == cells_.end()) continue;
      for (const Vec<D, double>& b : it->second)
        if (norm2(a - b) < near_ * near_) return true;
    }
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, D>;
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
  std::unordered_map<Cell, std::vector<Vec<D, double>>, Hash> cells_;
};

}  // namespace freshet

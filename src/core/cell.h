// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The cubes of one support radius that space is cut into, counted from the origin. All backends
/// visit neighbours cell by cell in row-major order (x fastest) and by id inside a cell: an order
/// that depends on the state alone.
template <int D> struct Cell {
  std::int64_t c[D];
  FRESHET_HD bool operator==(const Cell& o) const {
    bool same = true;
    for (int d = 0; d < D; ++d) same &= c[d] == o.c[d];
    return same;
  }
  FRESHET_HD bool operator<(const Cell& o) const {
    for (int d = D - 1; d > 0; --d)
      if (c[d] != o.c[d]) return c[d] < o.c[d];
    return c[0] < o.c[0];
  }
};

/// Which cell a position lies in.
template <int D> class Cells {
 public:
  Cells() = default;
  /// A hair larger than the support radius, and computed in doubles, so that no rounding parts
  /// neighbours by two cells.
  explicit Cells(Real support_radius) : inverse_(1 / (double(support_radius) * (1 + 1e-9))) {}

  /// A NaN or a flight beyond all bounds lands in some cell, harmlessly.
  FRESHET_HD Cell<D> operator()(Vec<D> x) const {
    Cell<D> cell;
    for (int d = 0; d < D; ++d) {
      const double c = double(component(x, d)) * inverse_;
      const auto toward_zero = c > -1e15 && c < 1e15 ? std::int64_t(c) : 0;
      cell.c[d] = toward_zero - (double(toward_zero) > c);
    }
    return cell;
  }

 private:
  double inverse_ = 1;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

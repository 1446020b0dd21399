// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The bricks that space is cut into, counted from the origin: a support radius along y and z, and
/// `Cells::split` of them to a support radius along x. All backends visit neighbours cell by cell
/// in row-major order (x fastest) and by id inside a cell: an order that depends on the state
/// alone.
template <int D> struct Cell {
  std::int32_t c[D];
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
  static constexpr int split = 4;

  Cells() = default;
  /// A hair larger than the support radius, and computed in doubles, so that no rounding parts
  /// neighbours by more than `split` cells along x, or one along the others.
  explicit Cells(Real support_radius)
      : side_(double(support_radius) * (1 + 1e-9)), inverse_(1 / side_) {}

  /// x along axis d, counted in cells; a flight beyond all bounds ends at the last cell, and so
  /// does a NaN.
  FRESHET_HD double along(Real x, int d) const {
    const double c = double(x) * (d == 0 ? split * inverse_ : inverse_);
    const double below = c < last ? c : last;
    return below > -last ? below : -last;
  }
  FRESHET_HD Cell<D> operator()(Vec<D> x) const {
    Cell<D> cell;
    for (int d = 0; d < D; ++d) cell.c[d] = floor(along(component(x, d), d));
    return cell;
  }
  /// Where a cell begins along an axis.
  FRESHET_HD double begin(double c, int d) const { return c * (d == 0 ? side_ / split : side_); }
  FRESHET_HD static std::int32_t floor(double c) {
    const auto toward_zero = std::int32_t(c);
    return toward_zero - (double(toward_zero) > c);
  }

 private:
  static constexpr double last = 1e9;
  double side_ = 1, inverse_ = 1;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

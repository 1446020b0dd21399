// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A cell of the search grid, counted from the origin. A cell is a support radius wide along y and
/// z, and 1/`Cells::split` of it along x. All backends visit neighbours cell by cell in row-major
/// order (x fastest) and by id inside a cell. This order depends on the state alone.
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

/// Maps positions to cells. The cells' borders are shifted by an odd fraction of a cell from the
/// origin: particles on a lattice would else lie on borders, where rounding decides about their
/// cell, and where a search for several targets together ends.
template <int D> class Cells {
 public:
  static constexpr int split = 4;

  Cells() = default;
  /// The side is larger than the support radius by 1e-9 of it and is computed in double. Rounding
  /// can therefore not separate neighbours by more than `split` cells along x, or by more than one
  /// cell along y and z.
  explicit Cells(Real support_radius)
      : side_(double(support_radius) * (1 + 1e-9)), inverse_(1 / side_) {}

  /// x along axis d in units of cells, clamped to ±1e9. A NaN is mapped to the last cell.
  FRESHET_HD double along(Real x, int d) const {
    const double c = double(x) * (d == 0 ? split * inverse_ : inverse_) + shift;
    const double below = c < last ? c : last;
    return below > -last ? below : -last;
  }
  FRESHET_HD Cell<D> operator()(Vec<D> x) const {
    Cell<D> cell;
    for (int d = 0; d < D; ++d) cell.c[d] = floor(along(component(x, d), d));
    return cell;
  }
  /// The lower end of a cell along axis d [m].
  FRESHET_HD double begin(double c, int d) const {
    return (c - shift) * (d == 0 ? side_ / split : side_);
  }
  FRESHET_HD static std::int32_t floor(double c) {
    const auto toward_zero = std::int32_t(c);
    return toward_zero - (double(toward_zero) > c);
  }

 private:
  static constexpr double last = 1e9, shift = 0.381966;
  double side_ = 1, inverse_ = 1;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

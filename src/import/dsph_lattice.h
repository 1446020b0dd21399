// SPDX-License-Identifier: MIT
/// The lattice of GenCase: its places are void, fluid or boundary, as the last command drew them.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "import/placement.h"

namespace freshet {

class DsphLattice {
 public:
  using Point = Vec<3, double>;
  using Index = std::array<long, 3>;
  /// A box of places.
  struct Block {
    Index first{}, count{};
  };

  /// Places `reference` + k `spacing` from `low` to `high`. In 2D there is one layer, at low.z.
  DsphLattice(const Point& reference, const Point& low, const Point& high, double spacing,
              int dimension);

  double spacing() const { return spacing_; }
  const Index& counts() const { return counts_; }
  Point place(const Index& i) const;
  /// The place nearest to x on an axis; it may be outside.
  long nearest(int axis, double x) const;
  double coordinate(int axis, long i) const;
  bool contains(int axis, long i) const { return i >= 0 && i < counts_[std::size_t(axis)]; }

  /// > 0: fluid; < 0: boundary; 0: void.
  std::int16_t& at(const Index& i) { return marks_[offset(i)]; }
  std::int16_t at(const Index& i) const { return marks_[offset(i)]; }

  /// Calls visit(index) for all places in a box, and half a spacing around it.
  template <class Visit> void each_in(const Bounds& box, Visit visit) const {
    Index low, high;
    if (!range_of(box, low, high)) return;
    for (long k = low[2]; k <= high[2]; ++k)
      for (long j = low[1]; j <= high[1]; ++j)
        for (long i = low[0]; i <= high[0]; ++i) visit(Index{i, j, k});
  }

  /// Marks the void that is connected to `seed` within a box. Returns the number of places.
  long fill(const Point& seed, const Bounds& box, std::int16_t mark);
  /// Boxes that cover the places with a mark, without overlap.
  std::vector<Block> blocks(std::int16_t mark) const;
  /// The bounds of the places that are not void, or of the fluid.
  Bounds extent(bool fluid_only) const;

 private:
  std::size_t offset(const Index& i) const {
    return std::size_t((i[2] * counts_[1] + i[1]) * counts_[0] + i[0]);
  }
  bool range_of(const Bounds& box, Index& low, Index& high) const;

  Point origin_;
  double spacing_;
  int dimension_;
  Index counts_{};
  std::vector<std::int16_t> marks_;
};

}  // namespace freshet

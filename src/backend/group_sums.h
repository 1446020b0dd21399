// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <vector>

#include "backend/fixed_point.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sums of several numbers per particle over groups of particles. They are equal in any order. One
/// thread computes them, because grouped sets are small.
class GroupSums {
 public:
  /// sums[g][c] = sum of map(i).value[c] over the i < n with map(i).group == g.
  template <class Map, class Sum> void add(int n, int groups, const Map& map, Sum* sums) {
    constexpr int components = Sum::size;
    Sum most{};
    for (int i = 0; i < n; ++i) {
      const auto item = map(i);
      for (int c = 0; c < components; ++c)
        if (!(std::abs(item.value[c]) <= most[c])) most[c] = std::abs(item.value[c]);
    }
    whole_.assign(std::size_t(groups) * components, 0);
    for (int c = 0; c < components; ++c) {
      const FixedPoint fixed(most[c], n);
      for (int i = 0; i < n; ++i) {
        const auto item = map(i);
        whole_[std::size_t(item.group * components + c)] += fixed.whole(item.value[c]);
      }
      for (int g = 0; g < groups; ++g)
        sums[g][c] = fixed.value(whole_[std::size_t(g * components + c)]);
    }
  }

 private:
  std::vector<std::int64_t> whole_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/cell.h"
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particles sorted by cube; cubes are found by a hash, so the search is O(N). A cube's side is the
/// support radius: it consists of `Cells::split` cells in a row. Memory depends on the number of
/// particles only, not on their distance.
template <int D> class CellGrid {
 public:
  struct Entry {
    Vec<D> x;
    int index;
    std::int32_t along_x;  // coordinate of its cell along x
  };
  /// The particles' indices count from `first`.
  void build(Real support_radius, Field<Vec<D>> x, int n, int first = 0) {
    cell_of_ = Cells<D>(support_radius);
    sort_by_bucket(x, n, first);
    part_into_groups();
  }

  /// Calls visit(entry, candidates) for every particle of this grid. The candidates are the
  /// particles of `sources`, then of `copies`, in its cube and the cubes around it. Their order is
  /// by cell, row-major (x fastest), and ascending in a cell. They are gathered once for all
  /// particles of a cube.
  template <class Visit>
  void for_each(const CellGrid& sources, const CellGrid& copies, const Visit& visit) {
    for (const Group& group : groups_) {
      candidates_.clear();
      gather(group, sources);
      if (!copies.entries_.empty()) gather(group, copies);
      for (int at = group.first; at < group.last; ++at) visit(entries_[at], candidates_);
    }
  }

  Cell<D> cell_of(Vec<D> x) const { return cell_of_(x); }

 private:
  struct Group {  // the particles of one cube
    Cell<D> cube;
    int first, last;
  };

  void gather(const Group& group, const CellGrid& sources) {
    constexpr int around = D == 3 ? 27 : 9;
    for (int k = 0; k < around; ++k) {
      Cell<D> cube = group.cube;
      for (int d = 0, part = k; d < D; ++d, part /= 3) cube.c[d] += part % 3 - 1;
      if (const Group* near = sources.find(cube))
        candidates_.insert(candidates_.end(), sources.entries_.begin() + near->first,
                           sources.entries_.begin() + near->last);
    }
  }

  /// The cube that contains a cell.
  static Cell<D> cube_of(Cell<D> cell) {
    static_assert(Cells<D>::split == 4);
    cell.c[0] >>= 2;  // rounds down
    return cell;
  }

  std::size_t bucket(const Cell<D>& cube) const {
    std::uint64_t hash = 0;
    for (const std::int32_t c : cube.c) {
      hash = (hash ^ std::uint64_t(c)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return hash & (first_.size() - 2);  // first_ has one more than a power of two
  }

  void sort_by_bucket(Field<Vec<D>> x, int n, int first) {
    std::size_t buckets = 64;
    while (buckets < 2 * std::size_t(n)) buckets *= 2;
    first_.assign(buckets + 1, 0);
    bucket_of_.resize(std::size_t(n));
    entries_.resize(std::size_t(n));
    for (int i = 0; i < n; ++i) ++first_[(bucket_of_[i] = bucket(cube_of(cell_of(x[i])))) + 1];
    for (std::size_t b = 1; b <= buckets; ++b) first_[b] += first_[b - 1];
    cursor_.assign(first_.begin(), first_.end() - 1);
    for (int i = 0; i < n; ++i)
      entries_[cursor_[bucket_of_[i]]++] = {x[i], first + i, cell_of(x[i]).c[0]};
  }

  /// Separates cubes that share a bucket. Afterwards first_ counts groups instead of entries.
  void part_into_groups() {
    groups_.clear();
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) {
      const int begin = first_[b], end = first_[b + 1];
      first_[b] = int(groups_.size());
      const auto cube = [&](const Entry& p) { return cube_of(cell_of(p.x)); };
      const auto less = [&](const Entry& p, const Entry& q) { return cube(p) < cube(q); };
      if (begin == end) continue;
      if (!std::is_sorted(entries_.begin() + begin, entries_.begin() + end, less))
        std::stable_sort(entries_.begin() + begin, entries_.begin() + end, less);
      for (int at = begin; at < end; ++at) {
        const Cell<D> own = cube(entries_[at]);
        if (at == begin || !(groups_.back().cube == own)) groups_.push_back({own, at, at});
        groups_.back().last = at + 1;
      }
    }
    first_.back() = int(groups_.size());
    for (const Group& g : groups_)
      std::sort(entries_.begin() + g.first, entries_.begin() + g.last,
                [](const Entry& p, const Entry& q) {
                  return p.along_x != q.along_x ? p.along_x < q.along_x : p.index < q.index;
                });
  }

  const Group* find(const Cell<D>& cube) const {
    const std::size_t b = bucket(cube);
    for (int g = first_[b]; g < first_[b + 1]; ++g)
      if (groups_[g].cube == cube) return &groups_[g];
    return nullptr;
  }

  Cells<D> cell_of_;
  std::vector<Entry> entries_, candidates_;
  std::vector<Group> groups_;
  std::vector<std::size_t> bucket_of_;
  std::vector<int> first_, cursor_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet

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

/// Particles sorted by cell, the cells found by their hash: neighbours in O(N). A cell's side is
/// the support radius. Memory depends on the number of particles, never on how far they have flown.
template <int D> class CellGrid {
 public:
  struct Entry {
    Vec<D> x;
    int index;
  };
  void build(Real support_radius, Field<Vec<D>> x, int n) {
    cell_of_ = Cells<D>(support_radius);
    sort_by_bucket(x, n);
    part_into_groups();
  }

  /// visit(entry, candidates) for every particle of this grid. The candidates are the particles of
  /// `sources` in its cell and the cells around it, cell by cell in row-major order (x fastest),
  /// ascending in a cell; they are gathered once for all particles of a cell, which then walk one
  /// row of equal length.
  template <class Visit> void for_each(const CellGrid& sources, const Visit& visit) {
    constexpr int around = D == 3 ? 27 : 9;
    for (const Group& group : groups_) {
      candidates_.clear();
      for (int k = 0; k < around; ++k) {
        Cell<D> cell = group.cell;
        for (int d = 0, part = k; d < D; ++d, part /= 3) cell.c[d] += part % 3 - 1;
        if (const Group* near = sources.find(cell))
          candidates_.insert(candidates_.end(), sources.entries_.begin() + near->first,
                             sources.entries_.begin() + near->last);
      }
      for (int at = group.first; at < group.last; ++at) visit(entries_[at], candidates_);
    }
  }

  Cell<D> cell_of(Vec<D> x) const { return cell_of_(x); }

 private:
  struct Group {  // the particles of one cell
    Cell<D> cell;
    int first, last;
  };

  std::size_t bucket(const Cell<D>& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cell.c) {
      hash = (hash ^ std::uint64_t(c)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return hash & (first_.size() - 2);  // first_ has one more than a power of two
  }

  void sort_by_bucket(Field<Vec<D>> x, int n) {
    std::size_t buckets = 64;
    while (buckets < 2 * std::size_t(n)) buckets *= 2;
    first_.assign(buckets + 1, 0);
    bucket_of_.resize(std::size_t(n));
    entries_.resize(std::size_t(n));
    for (int i = 0; i < n; ++i) ++first_[(bucket_of_[i] = bucket(cell_of(x[i]))) + 1];
    for (std::size_t b = 1; b <= buckets; ++b) first_[b] += first_[b - 1];
    cursor_.assign(first_.begin(), first_.end() - 1);
    for (int i = 0; i < n; ++i) entries_[cursor_[bucket_of_[i]]++] = {x[i], i};
  }

  /// Cells that share a bucket are told apart; first_ then counts groups instead of entries.
  void part_into_groups() {
    groups_.clear();
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) {
      const int begin = first_[b], end = first_[b + 1];
      first_[b] = int(groups_.size());
      const auto less = [&](const Entry& p, const Entry& q) { return cell_of(p.x) < cell_of(q.x); };
      if (begin == end) continue;
      if (!std::is_sorted(entries_.begin() + begin, entries_.begin() + end, less))
        std::stable_sort(entries_.begin() + begin, entries_.begin() + end, less);
      for (int at = begin; at < end; ++at) {
        const Cell<D> cell = cell_of(entries_[at].x);
        if (at == begin || !(groups_.back().cell == cell)) groups_.push_back({cell, at, at});
        groups_.back().last = at + 1;
      }
    }
    first_.back() = int(groups_.size());
  }

  const Group* find(const Cell<D>& cell) const {
    const std::size_t b = bucket(cell);
    for (int g = first_[b]; g < first_[b + 1]; ++g)
      if (groups_[g].cell == cell) return &groups_[g];
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

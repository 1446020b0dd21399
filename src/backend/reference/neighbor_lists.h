// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "backend/reference/cell_grid.h"
#include "freshet/methods.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// For every target the sources j with |x_ij| < h, including itself and copies. The order is that
/// of NeighborOrder and does not depend on the search method.
template <int D> class NeighborLists {
 public:
  struct Row {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };
  Row operator[](int i) const { return {list_.data() + begin_[i], list_.data() + end_[i]}; }

  void build(Search search, NeighborOrder order, Real h, const Particles<D>& targets,
             const Particles<D>& sources) {
    begin_.resize(std::size_t(targets.n));
    end_.resize(std::size_t(targets.n));
    size_ = 0;
    target_grid_.build(h, targets.x, targets.n);
    const bool same = targets.x.data == sources.x.data;
    if (!same) source_grid_.build(h, sources.x, sources.n);
    copy_grid_.build(h, {sources.x.data + sources.n}, sources.copies, sources.n);
    if (search == Search::grid) by_grid(h * h, same ? target_grid_ : source_grid_);
    else by_all_pairs(h * h, targets, sources);
    if (search == Search::grid && order == NeighborOrder::id)
      sort_by_id(targets.n, same && sources.copies == 0);
    if (search == Search::all_pairs && order == NeighborOrder::cell)
      sort_by_cell(targets.n, sources);
  }

 private:
  void by_grid(Real h2, const CellGrid<D>& sources) {
    target_grid_.for_each(sources, copy_grid_, [&](const auto& i, const auto& candidates) {
      int* out = start_row(i.index, candidates.size());
      for (const auto& j : candidates) {
        *out = j.index;  // kept only if j is near, without a branch
        out += norm2(i.x - j.x) < h2;
      }
      end_row(i.index, out);
    });
  }

  void by_all_pairs(Real h2, const Particles<D>& targets, const Particles<D>& sources) {
    for (int i = 0; i < targets.n; ++i) {
      int* out = start_row(i, std::size_t(sources.n + sources.copies));
      for (int j = 0; j < sources.n + sources.copies; ++j)
        if (norm2(targets.x[i] - sources.x[j]) < h2) *out++ = j;
      end_row(i, out);
    }
  }

  void sort_by_id(int n, bool same) {
    if (!same) {
      for (int i = 0; i < n; ++i) std::sort(list_.begin() + begin_[i], list_.begin() + end_[i]);
      return;
    }
    // The relation is symmetric: appending each j in turn to the rows of its neighbours gives every
    // row in ascending order, without a comparison.
    sorted_.resize(size_);
    cursor_ = begin_;
    for (int j = 0; j < n; ++j)
      for (const int i : (*this)[j]) sorted_[cursor_[i]++] = j;
    list_.swap(sorted_);
  }

  /// Sorts by cell in row-major order, then by index, copies last: the order of CellGrid::for_each.
  void sort_by_cell(int targets, const Particles<D>& sources) {
    for (int i = 0; i < targets; ++i)
      std::sort(list_.begin() + begin_[i], list_.begin() + end_[i], [&](int a, int b) {
        if ((a < sources.n) != (b < sources.n)) return a < b;
        const auto ca = target_grid_.cell_of(sources.x[a]), cb = target_grid_.cell_of(sources.x[b]);
        return ca == cb ? a < b : ca < cb;
      });
  }

  int* start_row(int i, std::size_t at_most) {
    if (list_.size() < size_ + at_most + 1) list_.resize(2 * (size_ + at_most + 1));
    begin_[i] = std::ptrdiff_t(size_);
    return list_.data() + size_;
  }
  void end_row(int i, const int* out) {
    size_ = std::size_t(out - list_.data());
    end_[i] = std::ptrdiff_t(size_);
  }

  CellGrid<D> target_grid_, source_grid_, copy_grid_;
  std::vector<int> list_, sorted_;
  std::vector<std::ptrdiff_t> begin_, end_, cursor_;
  std::size_t size_ = 0;  // entries used in list_, which may be longer
};

}  // namespace FRESHET_ISA
}  // namespace freshet

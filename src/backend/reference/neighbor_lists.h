// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "backend/reference/cell_grid.h"
#include "freshet/scene.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// For every particle the particles j with |x_ij| < h, itself among them, in one of two orders,
/// whichever way they were found.
template <int D> class NeighborLists {
 public:
  struct Row {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };
  Row operator[](int i) const { return {list_.data() + begin_[i], list_.data() + end_[i]}; }

  void build(Search search, NeighborOrder order, Real h, const Particles<D>& p) {
    begin_.resize(std::size_t(p.n));
    end_.resize(std::size_t(p.n));
    size_ = 0;
    grid_.build(h, p.x, p.n);
    if (search == Search::grid) by_grid(h * h);
    else by_all_pairs(h * h, p);
    if (search == Search::grid && order == NeighborOrder::id) sort_by_id(p.n);
    if (search == Search::all_pairs && order == NeighborOrder::cell) sort_by_cell(p);
  }

 private:
  void by_grid(Real h2) {
    grid_.for_each([&](const auto& i, const auto& candidates) {
      int* out = start_row(i.index, candidates.size());
      for (const auto& j : candidates) {
        *out = j.index;  // stays only if j is near: no branch to mispredict
        out += norm2(i.x - j.x) < h2;
      }
      end_row(i.index, out);
    });
  }

  void by_all_pairs(Real h2, const Particles<D>& p) {
    for (int i = 0; i < p.n; ++i) {
      int* out = start_row(i, std::size_t(p.n));
      for (int j = 0; j < p.n; ++j)
        if (norm2(p.x[i] - p.x[j]) < h2) *out++ = j;
      end_row(i, out);
    }
  }

  /// Ascending rows without a comparison: j in turn is handed to all whom it neighbours.
  void sort_by_id(int n) {
    sorted_.resize(size_);
    cursor_ = begin_;
    for (int j = 0; j < n; ++j)
      for (const int i : (*this)[j]) sorted_[cursor_[i]++] = j;
    list_.swap(sorted_);
  }

  /// Row-major order of cells, then id, as the grid visits them.
  void sort_by_cell(const Particles<D>& p) {
    for (int i = 0; i < p.n; ++i)
      std::sort(list_.begin() + begin_[i], list_.begin() + end_[i], [&](int a, int b) {
        const auto ca = grid_.cell_of(p.x[a]), cb = grid_.cell_of(p.x[b]);
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

  CellGrid<D> grid_;
  std::vector<int> list_, sorted_;
  std::vector<std::ptrdiff_t> begin_, end_, cursor_;
  std::size_t size_ = 0;  // of list_, which keeps room to spare
};

}  // namespace FRESHET_ISA
}  // namespace freshet

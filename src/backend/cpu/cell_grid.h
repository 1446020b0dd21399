// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>

#include "backend/cpu/buffer.h"
#include "backend/cpu/pack.h"
#include "backend/cpu/threads.h"
#include "core/cell.h"
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particles in the order of their cells (row-major) and of their ids inside a cell.
///
/// The cells form a torus around what is occupied: a particle far away wraps around into it, where
/// the test of distance tells it from the near ones. So cells are never more than a few a particle,
/// and neighbours never more than one cell apart.
template <int D> class CpuCellGrid {
 public:
  /// The torus cell of a cell, or -1 where none is.
  FRESHET_HD int index(const Cell<D>& cell) const {
    int at = 0;
    for (int d = D - 1; d >= 0; --d) {
      std::int64_t r = cell.c[d] - low_[d];
      if (r < 0 || r >= size_[d]) {
        if (!wraps_[d]) return -1;
        r %= size_[d];
        if (r < 0) r += size_[d];
      }
      at = at * size_[d] + int(r);
    }
    return at;
  }
  int begin(int cell) const { return start_.get()[cell]; }
  int end(int cell) const { return start_.get()[cell + 1]; }
  /// The cell of the particle at `i` of the sorted order.
  const Cell<D>& cell_of(int i) const { return cells_.get()[i]; }
  const Real* component(int d) const { return x_[d].get(); }
  /// Sorted place -> place before.
  const int* order() const { return order_.get(); }
  int n() const { return n_; }
  int cell_count() const { return cell_count_; }

  void build(const Threads& threads, Real support_radius, const Particles<D>& p) {
    n_ = p.n;
    const Cells<D> cells(support_radius);
    Cell<D>* unsorted = unsorted_.reserve(std::size_t(n_));
    threads.blocks(n_, [&](int b, int e) {
      for (int i = b; i < e; ++i) unsorted[i] = cells(p.x[i]);
    });
    choose_torus(threads);
    count(threads);
    place(threads, p);
  }

 private:
  /// As large as what is occupied, but at most two cells a particle: then the longest side wraps.
  void choose_torus(const Threads& threads) {
    const int parts = (n_ + Threads::block - 1) / Threads::block;
    Box* boxes = boxes_.reserve(std::size_t(parts));
    threads.blocks(n_, [&](int b, int e) {
      Box box;
      for (int i = b; i < e; ++i) box.add(unsorted_.get()[i]);
      boxes[b / Threads::block] = box;
    });
    Box all;
    for (int k = 0; k < parts; ++k) all.add(boxes[k]);
    std::int64_t sides[D];
    for (int d = 0; d < D; ++d) sides[d] = n_ ? all.high.c[d] - all.low.c[d] + 1 : 1;
    const auto cells = [&] {
      double product = 1;
      for (const auto side : sides) product *= double(side);
      return product;
    };
    bool wraps[D] = {};
    while (cells() > std::max(64.0, 2.0 * n_)) {
      const auto d = std::max_element(sides, sides + D) - sides;
      sides[d] = std::max<std::int64_t>(3, sides[d] / 2);
      wraps[d] = true;
      if (sides[d] == 3) break;  // the longest is three: all are
    }
    for (int d = 0; d < D; ++d) {
      low_[d] = n_ ? all.low.c[d] : 0;
      size_[d] = int(sides[d]);
      wraps_[d] = wraps[d];
    }
    cell_count_ = int(cells());
  }

  /// How many particles of each part (one a thread) lie in each cell, then where they go.
  void count(const Threads& threads) {
    const int parts = threads.count();
    const auto cell_count = std::size_t(cell_count_);
    int* key = key_.reserve(std::size_t(n_));
    int* histogram = histogram_.reserve(std::size_t(parts) * cell_count);
    int* start = start_.reserve(cell_count + 1);
    threads.parts(parts, [&](int t) {
      int* mine = histogram + std::size_t(t) * cell_count;
      std::fill_n(mine, cell_count, 0);
      for (int i = first_of(t, parts); i < first_of(t + 1, parts); ++i)
        ++mine[key[i] = index(unsorted_.get()[i])];
    });
    int at = 0;
    for (std::size_t c = 0; c < cell_count; ++c) {
      start[c] = at;
      for (int t = 0; t < parts; ++t)
        at += std::exchange(histogram[std::size_t(t) * cell_count + c], at);
    }
    start[cell_count] = at;
  }

  void place(const Threads& threads, const Particles<D>& p) {
    const int parts = threads.count();
    int* order = order_.reserve(std::size_t(n_));
    threads.parts(parts, [&](int t) {
      int* mine = histogram_.get() + std::size_t(t) * std::size_t(cell_count_);
      for (int i = first_of(t, parts); i < first_of(t + 1, parts); ++i)
        order[mine[key_.get()[i]]++] = i;
    });
    Cell<D>* cells = cells_.reserve(std::size_t(n_));
    Real* x[D];
    for (int d = 0; d < D; ++d) x[d] = x_[d].reserve(std::size_t(n_ + lanes));
    threads.blocks(cell_count_, [&](int b, int e) {
      for (int c = b; c < e; ++c) sort_by_id(order + begin(c), order + end(c), p.id);
      for (int at = begin(b); at < end(e - 1); ++at) {
        cells[at] = unsorted_.get()[order[at]];
        Vec<D> y = p.x[order[at]];
        for (int d = 0; d < D; ++d) x[d][at] = freshet::component(y, d);
      }
    });
  }

  /// Insertion: a cell holds few particles, which kept their order since the last step but for
  /// those that came in; a crowd is sorted properly.
  static void sort_by_id(int* first, int* last, Field<std::uint64_t> id) {
    if (last - first > 64) {
      std::sort(first, last, [&](int a, int b) { return id[a] < id[b]; });
      return;
    }
    for (int* k = first; k < last; ++k) {
      const int one = *k;
      int* to = k;
      for (; to > first && id[to[-1]] > id[one]; --to) *to = to[-1];
      *to = one;
    }
  }

  int first_of(int part, int parts) const { return int(std::int64_t(n_) * part / parts); }

  struct Box {
    Cell<D> low, high;
    Box() {
      for (int d = 0; d < D; ++d) {
        low.c[d] = std::numeric_limits<std::int64_t>::max();
        high.c[d] = std::numeric_limits<std::int64_t>::min();
      }
    }
    void add(const Cell<D>& c) {
      for (int d = 0; d < D; ++d) {
        low.c[d] = std::min(low.c[d], c.c[d]);
        high.c[d] = std::max(high.c[d], c.c[d]);
      }
    }
    void add(const Box& b) { add(b.low), add(b.high); }
  };

  int n_ = 0, cell_count_ = 0;
  std::int64_t low_[D] = {};
  int size_[D] = {};
  bool wraps_[D] = {};
  Buffer<Cell<D>> unsorted_, cells_;
  Buffer<Box> boxes_;
  Buffer<int> key_, histogram_, start_, order_;
  Buffer<Real> x_[D];
};

}  // namespace FRESHET_ISA
}  // namespace freshet

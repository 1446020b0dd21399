// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "backend/cpu/buffer.h"
#include "backend/cpu/pack.h"
#include "backend/cpu/threads.h"
#include "core/cell.h"
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Particles in the order of their cells (row-major) and of their ids inside a cell.
///
/// The cells form a torus around the occupied region. A particle far away wraps around into it, and
/// the distance test separates it from near particles. The number of cells is therefore limited to
/// a few per particle. An axis that wraps has enough cells that a search visits none twice.
template <int D> class CpuCellGrid {
 public:
  /// A row of cells along x: the index of its first cell, and the number of cells (0 outside).
  struct Row {
    int first, cells;
  };
  /// The row with the coordinates of `cell` along y and z; c[0] is ignored.
  FRESHET_HD Row row(const Cell<D>& cell) const {
    int at = 0;
    for (int d = D - 1; d > 0; --d) {
      const int r = (cell.c[d] - low_[d]) & wrap_[d];
      if (r < 0 || r >= size_[d]) return {0, 0};
      at = at * size_[d] + r;
    }
    return {at * size_[0], size_[0]};
  }
  /// The index in its row of a cell with coordinate x along x. It may be outside the row unless
  /// rows wrap.
  FRESHET_HD int place_in_row(std::int32_t x) const { return (x - low_[0]) & wrap_[0]; }
  bool rows_wrap() const { return wrap_[0] != -1; }

  const Cells<D>& cells() const { return cells_; }
  /// The sorted index of the first particle of each cell, then the number of particles.
  const int* starts() const { return start_.get(); }
  int begin(int cell) const { return start_.get()[cell]; }
  int end(int cell) const { return start_.get()[cell + 1]; }
  /// Component d of all sorted positions; `lanes` values after the last may be read.
  const Real* component(int d) const { return x_[d].get(); }
  FRESHET_HD Vec<D> position(int i) const {
    if constexpr (D == 3) return {component(0)[i], component(1)[i], component(2)[i]};
    else return {component(0)[i], component(1)[i]};
  }
  /// The index before sorting, by sorted index.
  const int* order() const { return order_.get(); }
  int n() const { return n_; }
  int cell_count() const { return cell_count_; }

  void build(const Threads& threads, Real support_radius, const Particles<D>& p) {
    n_ = p.n;
    cells_ = Cells<D>(support_radius);
    choose_torus(threads, p);
    part_into_buckets(threads, p);
    sort_buckets(threads, p);
  }

  /// Writes positions and ids in sorted order to p.
  void write(const Threads& threads, const Particles<D>& p) const {
    threads.blocks(n_, [&](int b, int e) {
      for (int i = b; i < e; ++i) {
        Vec<D> y;
        for (int d = 0; d < D; ++d) freshet::component(y, d) = component(d)[i];
        p.x[i] = y;
      }
      std::memcpy(p.id.data + b, id_.get() + b, std::size_t(e - b) * sizeof *id_.get());
    });
  }

 private:
  /// Chooses a torus as large as the occupied region, with at most eight cells per particle. If
  /// there were more, the longest sides wrap, with lengths that are powers of two.
  void choose_torus(const Threads& threads, const Particles<D>& p) {
    const int parts = (n_ + Threads::block - 1) / Threads::block;
    Box* boxes = boxes_.reserve(std::size_t(parts));
    threads.blocks(n_, [&](int b, int e) {
      Box box;
      for (int i = b; i < e; ++i) box.add(p.x[i]);
      boxes[b / Threads::block] = box;
    });
    Box all;
    for (int k = 0; k < parts; ++k) all.add(boxes[k].low), all.add(boxes[k].high);
    if (n_ == 0) all.low = all.high = {};  // any place will do
    const Cell<D> low = cells_(all.low), high = cells_(all.high);
    std::int64_t sides[D];
    for (int d = 0; d < D; ++d) {
      low_[d] = low.c[d];
      sides[d] = std::max(std::int64_t(high.c[d]) - low.c[d] + 1, std::int64_t(1));
      wrap_[d] = -1;
    }
    const auto cells = [&] {
      double product = 1;
      for (const auto side : sides) product *= double(side);
      return product;
    };
    while (cells() > most_cells()) {
      const auto d = std::max_element(sides, sides + D) - sides;
      sides[d] = std::int64_t(std::bit_ceil(std::uint64_t(sides[d])) / 2);
      wrap_[d] = int(sides[d] - 1);
    }
    for (int d = 0; d < D; ++d) size_[d] = int(sides[d]);
    cell_count_ = int(cells());
  }

  /// The maximum number of cells. It is large enough that no wrapping side is shorter than 16.
  /// Arrays over cells have room for this number from the start, so a fluid that spreads allocates
  /// nothing.
  double most_cells() const { return std::max(16.0 * 16 * 16, 8.0 * n_); }

  /// The index of the torus cell of a position. A NaN is mapped to a border cell.
  FRESHET_HD int key(Vec<D> x) const {
    const Cell<D> cell = cells_(x);
    int at = 0;
    for (int d = D - 1; d >= 0; --d) {
      const int r = (cell.c[d] - low_[d]) & wrap_[d];
      at = at * size_[d] + std::clamp(r, 0, size_[d] - 1);
    }
    return at;
  }

  /// A bucket is a run of cells that one thread sorts in its cache.
  static constexpr int bucket_bits = 8;
  struct Item {
    int key, index;
  };

  /// Sorts particles into buckets. Each part (one per thread) counts its particles of each bucket,
  /// then moves them there.
  void part_into_buckets(const Threads& threads, const Particles<D>& p) {
    const int parts = threads.count();
    buckets_ = (cell_count_ + (1 << bucket_bits) - 1) >> bucket_bits;
    const auto buckets = std::size_t(buckets_);
    int* keys = key_.reserve(std::size_t(n_));
    const std::size_t most_buckets = std::size_t(most_cells()) / (1 << bucket_bits) + 1;
    int* histogram = histogram_.reserve(std::size_t(parts) * most_buckets);
    int* bucket = bucket_.reserve(most_buckets + 1);
    threads.parts(parts, [&](int t) {
      int* mine = histogram + std::size_t(t) * buckets;
      std::fill_n(mine, buckets, 0);
      for (int i = first_of(t, parts); i < first_of(t + 1, parts); ++i) {
        keys[i] = key(p.x[i]);
        ++mine[keys[i] >> bucket_bits];
      }
    });
    int at = 0;
    for (std::size_t b = 0; b < buckets; ++b) {
      bucket[b] = at;
      for (int t = 0; t < parts; ++t)
        at += std::exchange(histogram[std::size_t(t) * buckets + b], at);
    }
    bucket[buckets] = at;
    Item* items = items_.reserve(std::size_t(n_));
    threads.parts(parts, [&](int t) {
      int* mine = histogram + std::size_t(t) * buckets;
      for (int i = first_of(t, parts); i < first_of(t + 1, parts); ++i)
        items[mine[keys[i] >> bucket_bits]++] = {keys[i], i};
    });
  }

  void sort_buckets(const Threads& threads, const Particles<D>& p) {
    start_.reserve(std::size_t(most_cells()) + 1);
    order_.reserve(std::size_t(n_));
    id_.reserve(std::size_t(n_));
    for (Buffer<Real>& x : x_) x.reserve(std::size_t(n_ + lanes));
    constexpr int together = 8;
    threads.parts((buckets_ + together - 1) / together, [&](int k) {
      for (int b = k * together; b < std::min(buckets_, (k + 1) * together); ++b) sort_bucket(b, p);
    });
    start_.get()[cell_count_] = n_;
    for (Buffer<Real>& x : x_) std::fill_n(x.get() + n_, lanes, Real(0));
  }

  void sort_bucket(int b, const Particles<D>& p) {
    const int first_cell = b << bucket_bits;
    const int cells = std::min(1 << bucket_bits, cell_count_ - first_cell);
    const Item* items = items_.get();
    const int begin = bucket_.get()[b], end = bucket_.get()[b + 1];
    int next[1 << bucket_bits] = {};
    for (int k = begin; k < end; ++k) ++next[items[k].key - first_cell];
    int* start = start_.get() + first_cell;
    for (int c = 0, at = begin; c < cells; ++c) {
      start[c] = at;
      at += std::exchange(next[c], at);
    }
    int* order = order_.get();
    std::uint64_t* id = id_.get();
    for (int k = begin; k < end; ++k) {
      // Insertion sort: most particles have kept their order since the last step.
      const int index = items[k].index, c = items[k].key - first_cell;
      const std::uint64_t own = p.id[index];
      int to = next[c]++;
      for (; to > start[c] && id[to - 1] > own; --to) {
        id[to] = id[to - 1];
        order[to] = order[to - 1];
      }
      id[to] = own;
      order[to] = index;
    }
    for (int at = begin; at < end; ++at) {
      Vec<D> y = p.x[order[at]];
      for (int d = 0; d < D; ++d) x_[d].get()[at] = freshet::component(y, d);
    }
  }

  int first_of(int part, int parts) const { return int(std::int64_t(n_) * part / parts); }

  struct Box {
    Vec<D> low, high;
    Box() {
      for (int d = 0; d < D; ++d) {
        freshet::component(low, d) = std::numeric_limits<Real>::infinity();
        freshet::component(high, d) = -std::numeric_limits<Real>::infinity();
      }
    }
    FRESHET_HD void add(Vec<D> x) {  // ignores a NaN
      low = each(x, low, [](Real a, Real b) { return min(a, b); });
      high = each(x, high, [](Real a, Real b) { return max(a, b); });
    }
  };

  Cells<D> cells_;
  int n_ = 0, cell_count_ = 0, buckets_ = 0;
  int low_[D] = {}, size_[D] = {}, wrap_[D] = {};
  Buffer<Box> boxes_;
  Buffer<int> key_, histogram_, bucket_, start_, order_;
  Buffer<Item> items_;
  Buffer<std::uint64_t> id_;
  Buffer<Real> x_[D];
};

}  // namespace FRESHET_ISA
}  // namespace freshet
